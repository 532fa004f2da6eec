#include "ui/status_panel.h"

#include "core/grid_reuse.h"
#include "ui/panels.h"
#include "ui/stage_sentence.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

// Counts sum over substeps: the same ball may be in them many times.
std::string times(std::uint32_t count) { return grouped(count) + (count == 1 ? " time" : " times"); }

}  // namespace

std::vector<std::string> failure_sentences(const Status& status) {
    std::vector<std::string> sentences;
    if ((status.bits & STATUS_NOT_FINITE) != 0) {
        sentences.push_back("collide: a ball got a position or velocity that is no number, " +
                            times(status.not_finite) +
                            ". More substeps, a shorter step or less stiffness help; then restart.");
    }
    if ((status.bits & STATUS_OUT_OF_BOUNDS) != 0) {
        sentences.push_back("assign_cells: a ball's centre was outside the box, " + times(status.out_of_bounds) +
                            ". It counts as in the nearest cell.");
    }
    if ((status.bits & STATUS_OVER_CAPACITY) != 0) {
        sentences.push_back("build_grid: a key named a cell or ball that has no room, " + times(status.over_capacity) +
                            ". Its contacts are missing.");
    }
    if ((status.bits & STATUS_MISSED) != 0) {
        sentences.push_back("count_missed: a ball would not have found one that it touches, " + times(status.missed) +
                            ": balls go up to " + length_text(drift(status)) +
                            " while a grid is used. A wider cell factor or less reuse helps.");
    }
    return sentences;
}

void status_panel(const State& state, Commands& commands) {
    ImGui::PushTextWrapPos(26.0f * em());
    for (const std::string& sentence : failure_sentences(state.status)) {
        text(sentence);
    }
    ImGui::PopTextWrapPos();
    if (ImGui::Button("Forget")) {
        commands.push_back(ClearStatus{});
    }
}

}  // namespace ballpit::ui
