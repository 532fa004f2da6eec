#include "app/clock.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ballpit::app {

namespace {

constexpr double longest_frame_s = 0.05;  // with steps in it: longer ones make keys and sliders feel late
constexpr double longest_gap_s = 0.25;    // a window that was hidden or moved is not owed the time
constexpr int most_steps = 64;
constexpr int most_patience = 32;  // frames
constexpr int frames_behind = 4;   // that a device may be, until what it cannot do is seen

}  // namespace

void Clock::toggle_run() { state_ = running() ? RunState::paused : RunState::running; }

int Clock::steps_for_frame(double wall_s, double dt, double speed) {
    if (state_ != RunState::running) {
        const int steps = state_ == RunState::one_step ? 1 : 0;
        state_ = RunState::paused;
        debt_s_ = 0.0;
        last_steps_ = 0;  // the next frame's length says nothing about a run of steps
        held_back_ = false;
        return steps;
    }
    adapt(wall_s);
    hitches_ += wall_s > longest_gap_s ? 1 : 0;
    const int due = due_steps(std::min(wall_s, longest_gap_s), dt, speed);
    last_steps_ = std::min(due, allowed_);
    held_back_ = due > last_steps_;
    return last_steps_;
}

// What a step costs cannot be asked for (the GPU runs late), but a frame that got too long can be seen. Where one step
// more makes it so again and again, it is tried ever more rarely: each try is a frame that stutters.
void Clock::adapt(double wall_s) {
    if (last_steps_ > 0 && wall_s > longest_frame_s) {
        allowed_ = std::max(1, static_cast<int>(static_cast<double>(last_steps_) * longest_frame_s / wall_s));
        if (std::exchange(watched_, 0) > 0) {
            patience_ = std::min(2 * patience_, most_patience);
        }
        waited_ = 0;
        return;
    }
    if (watched_ > 0 && --watched_ == 0) {
        patience_ = 1;
    }
    if (held_back_ && ++waited_ >= patience_) {
        allowed_ = std::min(allowed_ + 1, most_steps);
        waited_ = 0;
        watched_ = frames_behind;
    }
}

int Clock::due_steps(double wall_s, double dt, double speed) {
    if (dt <= 0.0) {
        return 1;  // steps that take no time are never due, yet the class wants to see them run
    }
    debt_s_ += wall_s * speed;
    // Rounded, not cut off: a display that is a little early or late still gets one step a frame, and never 0, 2, 0, 2.
    const double due = std::min(std::floor(debt_s_ / dt + 0.5), static_cast<double>(most_steps) + 1.0);
    debt_s_ = std::clamp(debt_s_ - due * dt, -0.5 * dt, 0.5 * dt);
    return static_cast<int>(due);
}

}  // namespace ballpit::app
