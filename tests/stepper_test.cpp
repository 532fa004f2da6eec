// Stepping forth and back on the mirror, and what the timeline remembers.
#include "core/stepper.h"

#include "cpu/cpu_backend.h"
#include "support/catch.h"
#include "support/stepping.h"

using namespace ballpit;
using namespace ballpit::test;

namespace {

std::unique_ptr<Backend> mirror() { return std::make_unique<cpu::CpuBackend<float>>(); }

struct FakeState final : SavedState {
    explicit FakeState(std::size_t size) : SavedState(0), size_(size) {}
    std::size_t bytes() const override { return size_; }
    std::size_t size_;
};

Checkpoint checkpoint_of(std::size_t bytes) {
    Checkpoint checkpoint;
    checkpoint.state = std::make_shared<FakeState>(bytes);
    return checkpoint;
}

}  // namespace

TEST_CASE("back in every unit from every dispatch gives the bytes of the way there", "[stepper]") {
    for (const SortMethod sort : {SortMethod::bitonic, SortMethod::bitonic_fused, SortMethod::counting}) {
        Simulation simulation = stepping_simulation(mirror(), sort);
        check_every_position(simulation);
    }
}

TEST_CASE("whatever was done on the way, back and forth give the bytes of the way there", "[stepper]") {
    Simulation simulation = stepping_simulation(mirror(), SortMethod::bitonic_fused);
    check_changes_at_every_position(simulation);
}

TEST_CASE("300 steps with changes on the way, back and forth, end on the same hash", "[stepper]") {
    Simulation simulation = stepping_simulation(mirror(), SortMethod::bitonic_fused);
    check_long_way(simulation, 300);
}

TEST_CASE("a replay that arrives elsewhere is told with step and ball", "[stepper]") {
    Simulation simulation = stepping_simulation(mirror(), SortMethod::bitonic_fused);
    Stepper stepper(simulation, 1u << 20);
    for (int i = 0; i < 5; ++i) {
        stepper.forward(StepUnit::step);
    }
    stepper.update();
    REQUIRE_FALSE(stepper.divergence());
    stepper.go_to({{2, 1}, 0});
    auto positions = read_slot<vec4>(simulation.backend(), Slot::positions);
    positions[17].x += 0.001f;
    simulation.backend().write(Slot::positions, std::as_bytes(std::span(positions)));
    stepper.forward(StepUnit::step);
    stepper.update();
    REQUIRE(stepper.divergence());
    CHECK(stepper.divergence()->step == 3);
}

TEST_CASE("without balls a substep has no parts, and time goes on", "[stepper]") {
    Simulation simulation = stepping_simulation(mirror(), SortMethod::bitonic);
    Stepper stepper(simulation, 1u << 20);
    Settings none = simulation.settings();
    none.balls = 0;
    stepper.change(none);
    stepper.forward(StepUnit::pass);
    stepper.forward(StepUnit::stage);
    CHECK(stepper.position() == Position{{1, 0}, 0});
    stepper.back(StepUnit::pass);
    CHECK(stepper.position() == Position{{0, 1}, 0});
    stepper.back(StepUnit::step);
    stepper.back(StepUnit::step);
    CHECK(stepper.position() == Position{});
}

TEST_CASE("a change in the middle of a substep starts the substep again and forgets what came later", "[stepper]") {
    Simulation simulation = stepping_simulation(mirror(), SortMethod::bitonic);
    Stepper stepper(simulation, 1u << 20);
    for (int i = 0; i < 4; ++i) {
        stepper.forward(StepUnit::step);
    }
    stepper.go_to({{1, 1}, 3});
    Settings other = simulation.settings();
    other.gravity.z = -1.0;
    stepper.change(other);
    CHECK(stepper.position() == Position{{1, 1}, 0});
    stepper.go_to({{4, 0}, 0});
    stepper.update();
    CHECK_FALSE(stepper.divergence());
    CHECK(simulation.settings().gravity.z == -1.0);
    stepper.go_to({{1, 0}, 0});
    CHECK(simulation.settings().gravity.z != -1.0);
}

TEST_CASE("checkpoints thin out towards the past and stay within the budget", "[stepper]") {
    constexpr std::size_t bytes = 1000;
    constexpr std::size_t cost = bytes + checkpoint_overhead;
    Timeline timeline(100 * cost);
    for (std::uint64_t step = 0; step < 2000; ++step) {
        timeline.add({step, 0}, checkpoint_of(bytes));
        REQUIRE(timeline.used_bytes() <= timeline.budget());
    }
    CHECK(timeline.has({0, 0}));
    CHECK(timeline.has({1999, 0}));
    CHECK(timeline.has({1998, 0}));
    CHECK(timeline.checkpoint_count() == 100);
    // Nowhere is the way back longer than a fair share of the age.
    for (std::uint64_t step = 1; step < 1999; ++step) {
        const std::uint64_t found = timeline.at_or_before({step, 0}).first.step;
        INFO("step " << step << " starts from " << found);
        CHECK(static_cast<double>(step - found) <= 2.0 + 0.12 * static_cast<double>(1999 - step));
    }
    timeline.set_budget(10 * cost);
    CHECK(timeline.checkpoint_count() == 10);
    timeline.set_budget(0);
    CHECK(timeline.checkpoint_count() == 4);
    CHECK(timeline.has({1997, 0}));
    CHECK(timeline.has({0, 0}));
}

TEST_CASE("a timeline that begins late remembers only from there on", "[stepper]") {
    constexpr std::uint64_t late = std::uint64_t{1} << 39;  // of a scene that was saved after ten thousand years
    Timeline timeline(1u << 20);
    timeline.add({late, 0}, checkpoint_of(8));
    timeline.record_substeps(late, 3);
    CHECK(timeline.record_hash(late + 1, 17));
    CHECK(timeline.substeps_of(late) == 3);
    CHECK(timeline.substeps_of(late - 1) == 0);
    CHECK(timeline.hash(late + 1) == 17);
    CHECK_FALSE(timeline.hash(0));
    timeline.change({late, 1}, Settings{});
    CHECK_FALSE(timeline.hash(late + 1));
    CHECK(timeline.substeps_of(late) == 3);
}

TEST_CASE("a slider dragged while paused leaves its last value only, other changes all take hold again", "[stepper]") {
    Timeline timeline(1u << 20);
    timeline.add({0, 0}, checkpoint_of(8));
    Settings settings;
    for (int i = 0; i < 100; ++i) {
        settings.drag = 0.01 * i;
        timeline.change({0, 0}, settings);
    }
    REQUIRE(timeline.changes_at({0, 0}).size() == 1);
    CHECK(std::get<Settings>(timeline.changes_at({0, 0}).front()).drag == settings.drag);
    settings.balls = 7;
    timeline.change({0, 0}, settings);
    CHECK(timeline.changes_at({0, 0}).size() == 2);
}
