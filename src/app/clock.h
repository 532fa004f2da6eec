// When the simulation steps: run state, and how many steps of fixed dt a frame of the window is worth.
// Pure: time comes in as a number, so that a test can be any machine.
#pragma once

#include <cstdint>

namespace ballpit::app {

enum class RunState : std::uint8_t { running, paused, one_step };

class Clock {
public:
    RunState state() const { return state_; }
    bool running() const { return state_ == RunState::running; }
    void toggle_run();
    void pause() { state_ = RunState::paused; }
    /// One step in the next frame, then paused; a running clock stops after it.
    void step_once() { state_ = RunState::one_step; }

    /// Steps to run in a frame that comes `wall_s` seconds after the one before, with steps of `dt` s and `speed`
    /// simulated seconds a second. dt never changes: what a slow machine cannot do is dropped, not caught up.
    int steps_for_frame(double wall_s, double dt, double speed);
    /// Frames of a running clock that came so late that the time beyond a quarter of a second was dropped.
    std::uint32_t hitches() const { return hitches_; }
    void forget_hitches() { hitches_ = 0; }

private:
    void adapt(double wall_s);
    int due_steps(double wall_s, double dt, double speed);

    RunState state_ = RunState::paused;
    double debt_s_ = 0.0;  // simulated time that is due, within half a step of none
    int allowed_ = 1;      // steps that fit a frame without making it too long, learnt from the frames so far
    int last_steps_ = 0;
    std::uint32_t hitches_ = 0;
    bool held_back_ = false;  // whether the last frame ran fewer steps than were due
    int patience_ = 1;        // frames to wait until one step more is tried: longer, the oftener that was too much
    int waited_ = 0;          // frames
    int watched_ = 0;         // frames in which it is still to be seen whether the last step more was too much
};

}  // namespace ballpit::app
