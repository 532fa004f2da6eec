// Top left: frames a second, what makes them, and where the run stands.
#include <string>

#include "ui/panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

// Digits that the last row reads: drawn larger than the text around them.
void large_text(const std::string& words) {
    const float size = 1.6f * em();
    const ImVec2 extent = ImGui::GetFont()->CalcTextSizeA(size, FLT_MAX, 0.0f, words.c_str());
    ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), size, ImGui::GetCursorScreenPos(), packed(text_colour),
                                        words.c_str());
    ImGui::Dummy(extent);
}

std::string run_text(const State& state) {
    if (!state.running) {
        return "paused";
    }
    // Within a tenth of what was asked for is what was asked for.
    if (state.achieved > 0.0 && state.achieved < 0.9 * state.speed) {
        return format("slow motion: %.2g × real time", state.achieved);
    }
    return state.speed == 1.0 ? "real time" : format("%.3g × real time", state.speed);
}

}  // namespace

void frame_rate_panel(const State& state) {
    large_text(format("%.0f FPS   %.1f ms", state.fps, state.frame_ms));
    dim_text(grouped(state.settings.balls) + (state.settings.balls == 1 ? " ball" : " balls") + "  ·  " +
             std::string(computer_text(state.backend_name)) + "  ·  " + run_text(state));
    dim_text(format("t = %.3f s  ·  step %llu  ·  seed %llu", state.time,
                    static_cast<unsigned long long>(state.step_count), static_cast<unsigned long long>(state.seed)));
    if (state.play != nullptr && state.play->options.hand) {
        dim_text(state.play->held_ball
                     ? "hand: ball " + grouped(*state.play->held_ball)
                     : "hand: drag a wall or a ball  ·  " + std::string(key_hint(Action::toggle_hand)));
    }
    if (state.overlapping > 0) {
        dim_text(grouped(state.overlapping) + " balls found no free place: they start overlapping");
    }
}

}  // namespace ballpit::ui
