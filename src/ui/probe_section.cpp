// In the side panel: what is open to look into grid, neighbours and buffers, and how often copies are taken.
#include "ui/probe_panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

void windows(ProbeOptions& options, bool& changed) {
    if (!ImGui::BeginTable("probes", 2, ImGuiTableFlags_SizingStretchSame)) {
        return;
    }
    const auto toggle = [&changed](const char* label, bool& value, Action action, const char* about) {
        ImGui::TableNextColumn();
        changed |= key_checkbox(label, value, key_hint(action));
        tooltip(about);
    };
    toggle("Follow", options.follow, Action::toggle_follow, "One ball's way through the buffers. Click a ball.");
    toggle("Contacts", options.contacts, Action::toggle_contacts, "A line a contact, coloured by its overlap.");
    toggle("Cells", options.cells, Action::toggle_cells, "The table of cells.");
    toggle("Arrows", options.arrows, Action::toggle_arrows, "Velocities, as long as the way in a short time.");
    toggle("Buffers", options.buffers, Action::toggle_buffers, "Every buffer as a table.");
    toggle("Slice", options.slice, Action::toggle_slice, "A layer of the grid as a heat map.");
    toggle("Two ways", options.split, Action::toggle_split, "Brute force beside the grid.");
    ImGui::TableNextColumn();
    changed |= ImGui::Checkbox("Fade others", &options.fade);
    tooltip("Balls that no view speaks of become see-through.");
    ImGui::EndTable();
}

void rates(ProbeOptions& options, bool& changed) {
    if (options.arrows) {
        row_label("Arrow", "An arrow is as long as the way in this time.");
        changed |= ImGui::SliderFloat("##arrow", &options.arrow_seconds, 0.01f, 2.0f, "%.2f s",
                                      ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    }
    row_label("Copies",
              "How often the buffers are copied for these views while the simulation runs. Paused, they are exact.");
    changed |=
        ImGui::SliderScalar("##rate", ImGuiDataType_Double, &options.copies_a_second, &slowest_copies, &fastest_copies,
                            "%.3g a second", ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
}

}  // namespace

void probe_section(const State& state, Commands& commands) {
    if (!section("Look inside", false)) {
        return;
    }
    ProbeOptions options = state.probe->options;
    bool changed = false;
    windows(options, changed);
    rates(options, changed);
    if (changed) {
        commands.push_back(ChangeProbe{options});
    }
}

}  // namespace ballpit::ui
