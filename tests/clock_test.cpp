// The clock of the window: fixed dt, slow motion instead of longer steps, no catching up, one step at a time.
#include "app/clock.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "support/catch.h"

using ballpit::app::Clock;
using ballpit::app::RunState;

namespace {

constexpr double dt = 1.0 / 60.0;

Clock running_clock() {
    Clock clock;
    clock.toggle_run();
    return clock;
}

int total(Clock& clock, int frames, double wall_s, double speed = 1.0) {
    int steps = 0;
    for (int i = 0; i < frames; ++i) {
        steps += clock.steps_for_frame(wall_s, dt, speed);
    }
    return steps;
}

}  // namespace

TEST_CASE("the clock starts paused and stays so") {
    Clock clock;
    CHECK(clock.state() == RunState::paused);
    CHECK(total(clock, 100, dt) == 0);
    CHECK(clock.state() == RunState::paused);
}

TEST_CASE("run and pause take turns") {
    Clock clock;
    clock.toggle_run();
    CHECK(clock.running());
    clock.toggle_run();
    CHECK(clock.state() == RunState::paused);
    CHECK(total(clock, 10, dt) == 0);
}

TEST_CASE("one step is one step, however long the frame, and then a pause") {
    Clock clock;
    clock.step_once();
    CHECK(clock.steps_for_frame(10.0, dt, 10.0) == 1);
    CHECK(clock.state() == RunState::paused);
    CHECK(total(clock, 10, dt) == 0);

    Clock running = running_clock();
    total(running, 10, dt);
    running.step_once();
    CHECK(running.steps_for_frame(dt, dt, 1.0) == 1);
    CHECK(running.state() == RunState::paused);
}

TEST_CASE("run pressed while one step is due runs on") {
    Clock clock;
    clock.step_once();
    clock.toggle_run();
    CHECK(clock.running());
}

TEST_CASE("real time on displays of any rate") {
    for (const double rate : {24.0, 30.0, 59.94, 60.0, 75.0, 120.0, 144.0, 240.0, 1000.0}) {
        Clock clock = running_clock();
        const int frames = static_cast<int>(rate * 20.0);
        INFO(rate << " Hz");
        CHECK(total(clock, frames, 1.0 / rate) == Approx(20.0 / dt).margin(3.0));  // the first frames learn the pace
    }
}

TEST_CASE("a display at nearly 1/dt gets one step in every frame, jitter or not") {
    Clock clock = running_clock();
    for (int i = 0; i < 600; ++i) {
        const double jitter = (i % 3 - 1) * 0.2 * dt;
        CHECK(clock.steps_for_frame(dt + jitter, dt, 1.0) == 1);
    }
}

TEST_CASE("the speed of time changes the number of steps") {
    for (const double speed : {0.01, 0.1, 0.5, 2.0, 10.0}) {
        Clock clock = running_clock();
        INFO("speed " << speed);
        // Learning to run ten steps a frame costs the steps of a few frames.
        CHECK(total(clock, 6000, dt, speed) == Approx(6000.0 * speed).margin(60.0));
    }
}

// A machine whose step takes step_s of wall time, above drawing.
struct Machine {
    double step_s;
    double draw_s;

    std::vector<int> run(Clock& clock, int frames, double speed) const {
        std::vector<int> steps;
        double wall = draw_s;
        for (int i = 0; i < frames; ++i) {
            steps.push_back(clock.steps_for_frame(wall, dt, speed));
            wall = draw_s + step_s * steps.back();
        }
        return steps;
    }
};

TEST_CASE("a slow machine shows slow motion: one step a frame, never a spiral") {
    Clock clock = running_clock();
    const auto steps = Machine{0.4, 0.05}.run(clock, 200, 1.0);
    CHECK(std::accumulate(steps.begin(), steps.end(), 0) == 200);
}

TEST_CASE("many quick steps still fit a frame that stays short") {
    Clock clock = running_clock();
    const Machine machine{0.004, 0.01};  // ten steps would make a frame of 50 ms
    const auto steps = machine.run(clock, 500, 10.0);
    for (std::size_t i = 50; i < steps.size(); ++i) {
        CHECK(machine.draw_s + machine.step_s * steps[i] <= 0.06);
        CHECK(steps[i] >= 5);
    }
}

TEST_CASE("where two steps make a frame too long, nearly all frames have one") {
    Clock clock = running_clock();
    const Machine machine{0.037, 0.009};  // two steps: 83 ms
    machine.run(clock, 100, 1.0);
    const auto steps = machine.run(clock, 330, 1.0);
    CHECK(std::ranges::count(steps, 1) >= 320);
    CHECK(std::ranges::count(steps, 2) >= 1);  // or it would never learn that steps have become quicker
    CHECK(std::ranges::max(steps) == 2);
}

TEST_CASE("steps that have become quicker come in their number again") {
    Clock clock = running_clock();
    Machine{0.2, 0.01}.run(clock, 200, 10.0);
    const auto steps = Machine{0.004, 0.01}.run(clock, 100, 10.0);
    for (std::size_t i = 50; i < steps.size(); ++i) {
        CHECK(steps[i] >= 5);
    }
}

TEST_CASE("time that was lost is not caught up") {
    Clock clock = running_clock();
    total(clock, 100, dt);
    const int after_gap = clock.steps_for_frame(30.0, dt, 1.0);  // the window was dragged, the laptop slept
    CHECK(after_gap <= 16);
    CHECK(total(clock, 60, dt) == Approx(60).margin(1));
}

TEST_CASE("a pause forgets what was due") {
    Clock clock = running_clock();
    total(clock, 3, 0.4 * dt);
    clock.toggle_run();
    clock.steps_for_frame(dt, dt, 1.0);
    clock.toggle_run();
    CHECK(clock.steps_for_frame(0.4 * dt, dt, 1.0) == 0);
}

TEST_CASE("steps of no length run one a frame") {
    Clock clock = running_clock();
    CHECK(clock.steps_for_frame(dt, 0.0, 1.0) == 1);
    CHECK(clock.steps_for_frame(10.0, 0.0, 10.0) == 1);
}

TEST_CASE("steps longer than a frame come when they are due") {
    Clock clock = running_clock();
    int steps = 0;
    for (int i = 0; i < 600; ++i) {
        steps += clock.steps_for_frame(1.0 / 60.0, 1.0, 1.0);
    }
    CHECK(steps == Approx(10).margin(1));
}
