// In the side panel: what is thrown, the hand, and the walls that it moves.
#include <algorithm>

#include "ui/panels.h"
#include "ui/setting_row.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

void buttons(const State& state, Commands& commands) {
    const float half = column_width(2);
    const auto button = [&](const char* label, Action action, const char* about, bool on = false) {
        if (key_button(label, key_hint(action), half, on)) {
            commands.push_back(action);
        }
        tooltip(about);
    };
    button("Shoot a ball", Action::shoot_ball, "From the eye towards the pointer; it starts where it enters the box.");
    ImGui::SameLine();
    button("Add a cluster", Action::add_cluster, "Balls at rest, packed, before the eye.");
    button("Hand", Action::toggle_hand,
           "Drag a wall along its normal, or pull a ball by a spring. Beside them a drag looks around, as ever.",
           state.play->options.hand);
    ImGui::SameLine();
    button("Shake", Action::toggle_shake, "Swings the box; its walls' velocity enters the dashpot.",
           state.settings.laws.shake);
}

// A number that is thrown with: from a fifth to five times what the scene has.
bool number_row(const char* label, const char* about, const char* pattern, double usual, double& value) {
    const double low = usual / 5.0;
    const double high = usual * 5.0;
    row_label(label, about);
    ImGui::PushID(label);
    const bool changed = ImGui::SliderScalar("##value", ImGuiDataType_Double, &value, &low, &high, pattern,
                                             ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    ImGui::PopID();
    return changed;
}

void thrown_rows(const State& state, Commands& commands) {
    PlayOptions options = state.play->options;
    const PlayOptions& usual = state.play->usual;
    bool changed = number_row("Radius", "Of a thrown ball.", "%.3g m", usual.radius, options.radius);
    changed |= number_row("Density", "Of a thrown ball.", "%.4g kg/m³", usual.density, options.density);
    changed |= number_row("Speed", "Of a ball that is shot.", "%.3g m/s", usual.speed, options.speed);
    row_label("Cluster", "Balls in a cluster, as far as they fit.");
    constexpr std::uint32_t fewest = 1;
    changed |= ImGui::SliderScalar("##cluster", ImGuiDataType_U32, &options.cluster, &fewest, &largest_cluster,
                                   "%u balls", ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    if (changed) {
        commands.push_back(ChangePlay{options});
    }
}

// Rows that the settings panel leaves to this one.
bool moves_walls(const SettingInfo& info) {
    return !has_row(info) && !std::holds_alternative<Laws Settings::*>(info.member) &&
           !std::holds_alternative<std::optional<Pull> Settings::*>(info.member);
}

void wall_rows(const State& state, Commands& commands) {
    Settings edited = state.settings;
    bool changed = false;
    for (const SettingInfo& info : setting_table()) {
        if (moves_walls(info) && setting_applies(info, state.settings.laws)) {
            changed |= setting_row(info, state, edited);
        }
    }
    if (state.play->walls_moved && ImGui::Button("Walls back", ImVec2(column_width(1), 0.0f))) {
        edited.walls_low = edited.walls_high = dvec3(0.0);
        changed = true;
    }
    if (changed) {
        commands.push_back(ChangeSettings{edited});
    }
}

}  // namespace

void play_section(const State& state, Commands& commands) {
    if (!section("Play", false)) {
        return;
    }
    buttons(state, commands);
    thrown_rows(state, commands);
    if (state.settings.laws.walls) {
        wall_rows(state, commands);
    } else {
        wrapped_dim_text("This scene has no walls to move or shake; its laws (F4) can be given some.");
    }
}

}  // namespace ballpit::ui
