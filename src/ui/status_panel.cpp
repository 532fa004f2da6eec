#include "ui/status_panel.h"

#include "core/grid_reuse.h"
#include "ui/panels.h"
#include "ui/stage_sentence.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

std::vector<std::string> extreme_sentences(const ExtremeNumbers& numbers, bool alarms) {
    std::vector<std::string> sentences;
    for (const ExtremeInfo& info : extreme_table()) {
        const bool alarm = info.counted && info.extreme != Extreme::hitches;
        if (alarm == alarms && numbers[info.extreme] != 0.0) {
            sentences.push_back(extreme_text(info, numbers[info.extreme]));
        }
    }
    return sentences;
}

void status_panel(const State& state, Commands& commands) {
    ImGui::PushTextWrapPos(26.0f * em());
    for (const std::string& sentence : extreme_sentences(state.extremes, true)) {
        text(sentence);
    }
    if ((state.status.bits & STATUS_MISSED) != 0) {
        text("Balls go up to " + length_text(drift(state.status)) + " while a grid is used.");
    }
    if (state.status.quarantined_ball > 0) {
        text("The last of the balls in quarantine is number " + std::to_string(state.status.quarantined_ball - 1) +
             ".");
    }
    ImGui::PopTextWrapPos();
    if (ImGui::Button("Forget")) {
        commands.push_back(ClearStatus{});
    }
    if (state.status.quarantined_ball > 0) {
        ImGui::SameLine();
        if (ImGui::Button("Show it")) {
            commands.push_back(SelectBall{state.status.quarantined_ball - 1, true});
        }
        tooltip("Followed, it leads to the next one in quarantine.");
    }
}

bool has_warning(const State& state) { return !extreme_sentences(state.extremes, false).empty(); }

void warnings_panel(const State& state, Commands& commands) {
    ImGui::PushTextWrapPos(26.0f * em());
    for (const std::string& sentence : extreme_sentences(state.extremes, false)) {
        text(sentence);
    }
    ImGui::PopTextWrapPos();
    if (ImGui::Button("Hide")) {
        commands.push_back(HideWarnings{});
    }
    if (state.extremes[Extreme::initial_overlap] != 0.0) {
        ImGui::SameLine();
        if (ImGui::Button("Relax")) {
            commands.push_back(RelaxOverlaps{});
        }
        tooltip("Pushes balls that overlap apart, before anything else moves.");
    }
    if (state.extremes[Extreme::explicit_dashpot_limit] != 0.0) {
        ImGui::SameLine();
        if (ImGui::Button("dashpot = semi_implicit")) {
            ChangeSettings change{state.settings};
            change.settings.dashpot = DashpotMethod::semi_implicit;
            commands.push_back(change);
        }
        tooltip("A dashpot that no substep is too long for.");
    }
}

}  // namespace ballpit::ui
