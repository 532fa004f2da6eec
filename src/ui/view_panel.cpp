// What is drawn, and how large the text is.
#include <algorithm>
#include <array>
#include <utility>

#include "ui/panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

constexpr std::array<const char*, ball_colours> colour_names = {
    "a tint for each ball",    "texture only", "speed", "grid cell", "slot", "contacts", "radius",
    "difference to the mirror"};

// Until one is chosen, the one shown as chosen is that which is drawn.
bool look_row(const State& state, ViewOptions& view) {
    row_label(
        "Look",
        "A model of triangles; a sphere found by ray in each pixel: cheaper for many balls; or that in two colours, "
        "without shadows, on a plain ground: for a CPU that draws.");
    constexpr std::array<std::pair<Look, const char*>, 3> looks = {
        {{Look::model, "model"}, {Look::impostor, "impostor"}, {Look::simple, "simple"}}};
    const float inner = ImGui::GetStyle().ItemInnerSpacing.x;
    const float gap = 0.5f * inner;
    float wanted = -gap;
    for (const auto& each : looks) {
        wanted += ImGui::GetFrameHeight() + inner + ImGui::CalcTextSize(each.second).x + gap;
    }
    // Beside a scroll bar the three do not fit where other rows begin: the label is short, so they begin further left.
    const float lacking = std::max(0.0f, wanted - ImGui::GetContentRegionAvail().x);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() - lacking);
    bool changed = false;
    for (const auto& [look, name] : looks) {
        if (look != looks.front().first) {
            ImGui::SameLine(0.0f, gap);
        }
        if (ImGui::RadioButton(name, drawn_look(view.look, state.software) == look)) {
            view.look = look;
            changed = true;
        }
    }
    return changed;
}

bool colour_row(const State& state, ViewOptions& view) {
    row_label("Colour", "What the colour of a ball tells. Shift+V: the next choice.");
    const auto chosen = static_cast<std::size_t>(view.colour);
    if (!ImGui::BeginCombo("##colour", colour_names[chosen])) {
        return false;
    }
    if (state.close_popups) {
        ImGui::CloseCurrentPopup();
    }
    bool changed = false;
    for (std::size_t i = 0; i < colour_names.size(); ++i) {
        if (ImGui::Selectable(colour_names[i], i == chosen) && i != chosen) {
            view.colour = static_cast<BallColour>(i);
            changed = true;
        }
    }
    ImGui::EndCombo();
    return changed;
}

bool toggles(ViewOptions& view) {
    bool changed = false;
    if (ImGui::BeginTable("toggles", 3, ImGuiTableFlags_SizingStretchProp)) {
        const auto toggle = [&changed](const char* label, bool& value, std::string_view keys) {
            ImGui::TableNextColumn();
            changed |= key_checkbox(label, value, keys);
        };
        toggle("Box", view.box, "");
        toggle("Ground", view.ground, "");
        toggle("Light", view.light, "");
        toggle("Occupancy", view.occupancy, key_hint(Action::toggle_occupancy));
        toggle("Timings", view.timings, key_hint(Action::toggle_timings));
        toggle("Help", view.help, key_hint(Action::toggle_help));
        ImGui::EndTable();
    }
    return changed;
}

void text_size_row(const State& state, Commands& commands) {
    row_label("Text size", "Text grows with the window; this makes it larger or smaller.");
    float size = state.text_size;
    // Only steps: every size needs its own font texture.
    if (ImGui::SliderFloat("##text", &size, smallest_text, largest_text, "%.2f ×")) {
        commands.push_back(ChangeTextSize{size});
    }
}

}  // namespace

void view_panel(const State& state, Commands& commands) {
    if (!section("View", true)) {
        return;
    }
    ViewOptions view = state.view;
    bool changed = look_row(state, view);
    changed |= colour_row(state, view);
    changed |= toggles(view);
    if (changed) {
        commands.push_back(ChangeView{view});
    }
    const float half = column_width(2);
    for (const Action action : {Action::camera_home, Action::full_screen}) {
        const bool home = action == Action::camera_home;
        if (key_button(home ? "Camera" : "Full screen", key_hint(action), half)) {
            commands.push_back(action);
        }
        if (home) {
            ImGui::SameLine();
        }
    }
    text_size_row(state, commands);
}

}  // namespace ballpit::ui
