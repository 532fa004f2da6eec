// Brute force beside the grid: what each of them had to do, and what the grid did not see.
#include <algorithm>
#include <string>

#include "ui/probe_panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

const ImVec4 missed_text{1.0f, 0.45f, 0.38f, 1.0f};

void count_row(const char* what, const std::string& value, bool alarm = false) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    dim_text(what);
    ImGui::TableNextColumn();
    const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(value.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, room));
    if (alarm) {
        ImGui::PushStyleColor(ImGuiCol_Text, missed_text);
        text(value);
        ImGui::PopStyleColor();
    } else {
        text(value);
    }
}

}  // namespace

void split_counts(const SplitSide& side) {
    text(side.title);
    if (!ImGui::BeginTable("counts", 2, ImGuiTableFlags_SizingFixedFit)) {
        return;
    }
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthFixed, 8.0f * em());
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthFixed, 7.0f * em());
    const auto number = [&](std::uint64_t value) { return side.known ? grouped(value) : std::string("–"); };
    count_row("pairs tested", number(side.tested));
    count_row("contacts found", number(side.contacts));
    count_row("contacts missed", number(side.missed), side.known && side.missed > 0);
    count_row("a substep", side.ms_per_substep ? format("%.3g ms", *side.ms_per_substep) : std::string("–"));
    ImGui::EndTable();
}

void split_panel(const State& state, Commands& commands) {
    text("Cell width");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(11.0f * em());
    double factor = state.settings.cell_factor;
    if (ImGui::SliderScalar("##factor", ImGuiDataType_Double, &factor, &smallest_cell_factor, &largest_cell_factor,
                            "%.2f diameters", ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp)) {
        Settings settings = state.settings;
        settings.cell_factor = factor;
        commands.push_back(ChangeSettings{settings});
    }
    ImGui::SameLine();
    if (key_button("Close", key_hint(Action::toggle_split), 5.0f * em())) {
        commands.push_back(Action::toggle_split);
    }
    if (state.probe->apart) {
        dim_text("a ball's two places differ by up to " + short_number(*state.probe->apart) + " m");
        tooltip(
            "Both sides add the same forces, but in another order: sums of floats differ in their last digit, and "
            "every collision makes that larger.");
    }
}

}  // namespace ballpit::ui
