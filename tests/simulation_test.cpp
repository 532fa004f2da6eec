// A running scene on the mirror: determinism, the clock, changes in the middle of a run.
#include "core/simulation.h"

#include <cmath>
#include <memory>

#include "cpu/cpu_backend.h"
#include "support/catch.h"
#include "support/input_error.h"
#include "support/scenes.h"

using namespace ballpit;

namespace {

Simulation simulation_of(const Scene& scene, std::uint32_t balls, std::uint64_t seed = 42) {
    Settings settings = scene.settings;
    settings.balls = balls;
    return {scene, settings, seed, std::make_unique<cpu::CpuBackend<float>>()};
}

Simulation rain(std::uint32_t balls, std::uint64_t seed = 42) {
    return simulation_of(test::shipped_scene("rain"), balls, seed);
}

void run(Simulation& simulation, int steps) {
    for (int i = 0; i < steps; ++i) {
        simulation.step();
    }
}

Scene free_fall() {
    Scene scene;
    scene.name = "Free fall";
    scene.half_extent = dvec3(100.0);
    scene.settings.laws.gravity = true;
    scene.balls = {{{0, 0, 10}, {1, -2, 3}, 0.1, 1.0, std::nullopt}};
    scene.settings.balls = 1;
    scene.settings.dt = 1.0 / 60.0;
    scene.settings.substeps = 8;
    return scene;
}

}  // namespace

TEST_CASE("the same run twice is the same state, bit for bit", "[simulation]") {
    Simulation first = rain(300);
    Simulation second = rain(300);
    run(first, 30);
    run(second, 30);
    CHECK(hash_state(first.raw_state()) == hash_state(second.raw_state()));
    CHECK(first.step_count() == 30);
}

TEST_CASE("both sorts give the same run", "[simulation]") {
    std::uint64_t hashes[2] = {};
    for (const SortMethod sort : {SortMethod::bitonic, SortMethod::bitonic_fused}) {
        Simulation simulation = rain(300);
        Settings settings = simulation.settings();
        settings.sort = sort;
        simulation.change(settings);
        run(simulation, 30);
        hashes[static_cast<std::size_t>(sort)] = hash_state(simulation.raw_state());
    }
    CHECK(hashes[0] == hashes[1]);
}

TEST_CASE("a restart is the same run, with another seed another one", "[simulation]") {
    Simulation simulation = rain(200);
    const std::uint64_t start = hash_state(simulation.raw_state());
    run(simulation, 20);
    const std::uint64_t hash = hash_state(simulation.raw_state());
    CHECK(hash != start);
    simulation.restart(42);
    CHECK(hash_state(simulation.raw_state()) == start);
    CHECK(simulation.time() == 0.0);
    CHECK(simulation.step_count() == 0);
    run(simulation, 20);
    CHECK(hash_state(simulation.raw_state()) == hash);
    simulation.restart(43);
    CHECK(simulation.seed() == 43);
    run(simulation, 20);
    CHECK(hash_state(simulation.raw_state()) != hash);
}

TEST_CASE("looking at the synchronised state does not change the run", "[simulation]") {
    Simulation looked_at = rain(200);
    Simulation alone = rain(200);
    for (int i = 0; i < 20; ++i) {
        looked_at.step();
        alone.step();
        looked_at.synchronised_state();
    }
    CHECK(hash_state(looked_at.raw_state()) == hash_state(alone.raw_state()));
    CHECK(read_slot<Status>(looked_at.backend(), Slot::status)[0].out_of_bounds ==
          read_slot<Status>(alone.backend(), Slot::status)[0].out_of_bounds);
}

TEST_CASE("a substep in parts is the substep", "[simulation]") {
    Simulation whole = rain(100);
    Simulation parts = rain(100);
    for (int i = 0; i < 10; ++i) {
        whole.substep();
        const SubstepParams<double> params = parts.params();
        for (std::size_t k = 0; k < parts.schedule().dispatches.size(); ++k) {
            parts.backend().run(parts.schedule(), params, k, k + 1);
        }
        parts.end_substep();
    }
    CHECK(hash_state(whole.raw_state()) == hash_state(parts.raw_state()));
    CHECK(whole.time() == parts.time());
}

TEST_CASE("a change of the count keeps the balls that stay", "[simulation]") {
    Simulation simulation = rain(200);
    run(simulation, 20);
    const BallState before = simulation.synchronised_state();
    Settings settings = simulation.settings();
    for (const std::uint32_t count : {300u, 64u, 0u, 65u}) {
        const BallState kept = simulation.synchronised_state();
        settings.balls = count;
        simulation.change(settings);
        const BallState after = simulation.synchronised_state();
        REQUIRE(after.count() == count);
        for (std::size_t i = 0; i < std::min(kept.count(), after.count()); ++i) {
            REQUIRE(after.positions[i] == kept.positions[i]);
            REQUIRE(after.velocities[i] == kept.velocities[i]);
        }
        run(simulation, 1);
    }
    CHECK(before.count() == 200);
}

TEST_CASE("more balls widen a box with a reference count, fewer never close it in", "[simulation]") {
    Simulation simulation = rain(5000);
    CHECK(simulation.half_extent() == dvec3(4, 4, 6));
    Settings settings = simulation.settings();
    settings.balls = 20000;
    simulation.change(settings);
    CHECK(simulation.half_extent() == dvec3(8, 8, 6));
    settings.balls = 100;
    simulation.change(settings);
    CHECK(simulation.half_extent() == dvec3(8, 8, 6));
}

TEST_CASE("a change of a law's value keeps state and clock", "[simulation]") {
    Simulation simulation = rain(100);
    run(simulation, 7);
    const std::uint64_t hash = hash_state(simulation.raw_state());
    const double time = simulation.time();
    Settings settings = simulation.settings();
    settings.drag = 0.7;
    settings.stiffness = 50000;
    settings.gravity = {1, 2, -3};
    settings.cell_factor = 1.5;
    settings.sort = SortMethod::bitonic;
    settings.dt = 1.0 / 120.0;
    settings.substeps = 16;
    simulation.change(settings);
    CHECK(hash_state(simulation.raw_state()) == hash);
    CHECK(simulation.time() == time);
    CHECK(simulation.step_count() == 7);
    simulation.substep();
    CHECK(simulation.time() == Approx(time + 1.0 / 120.0 / 16.0).epsilon(1e-15));
}

TEST_CASE("a change of the restitution reaches the balls that have none of their own", "[simulation]") {
    Scene scene = free_fall();
    scene.settings.laws.contact = true;
    scene.settings.laws.restitution = true;
    scene.balls.push_back({{0, 0, 5}, {0, 0, 0}, 0.1, 1.0, 0.9});
    scene.settings.balls = 2;
    Simulation simulation = simulation_of(scene, 2);
    const auto before = read_slot<float>(simulation.backend(), Slot::damping_ratios);
    Settings settings = simulation.settings();
    settings.restitution = 0.5;
    simulation.change(settings);
    const auto after = read_slot<float>(simulation.backend(), Slot::damping_ratios);
    REQUIRE(before.size() == 2);
    REQUIRE(after.size() == 2);
    CHECK(after[0] > before[0]);
    CHECK(after[1] == before[1]);
}

TEST_CASE("a change of the integrator keeps positions and brings velocities to their time", "[simulation]") {
    Simulation simulation = rain(100);
    run(simulation, 7);
    const BallState before = simulation.synchronised_state();
    Settings settings = simulation.settings();
    settings.integrator = Integrator::historical;
    simulation.change(settings);
    const BallState after = simulation.raw_state();
    CHECK(after.velocity_lag == 0.0);
    CHECK(hash_state(after) == hash_state(before));
}

TEST_CASE("no change is no work", "[simulation]") {
    Simulation simulation = rain(100);
    run(simulation, 3);
    const BallState before = simulation.raw_state();
    simulation.change(simulation.settings());
    CHECK(simulation.raw_state().velocity_lag == before.velocity_lag);
    CHECK(hash_state(simulation.raw_state()) == hash_state(before));
}

TEST_CASE("a refused change leaves the run as it was", "[simulation]") {
    Simulation simulation = simulation_of(test::shipped_scene("two_balls"), 2);
    run(simulation, 5);
    const std::uint64_t hash = hash_state(simulation.raw_state());
    Settings settings = simulation.settings();
    settings.balls = 3;
    CHECK_THROWS_AS(simulation.change(settings), InputError);
    CHECK(simulation.settings().balls == 2);
    CHECK(hash_state(simulation.raw_state()) == hash);
    CHECK_THROWS_AS(simulation.load(test::shipped_scene("two_balls"), settings, 1), InputError);
    CHECK(simulation.settings().balls == 2);
    CHECK(hash_state(simulation.raw_state()) == hash);
}

TEST_CASE("another backend takes over in the middle, to the last bit", "[simulation]") {
    Simulation moved = rain(150);
    Simulation stayed = rain(150);
    run(moved, 10);
    run(stayed, 10);
    moved.use(std::make_unique<cpu::CpuBackend<float>>());
    run(moved, 10);
    run(stayed, 10);
    CHECK(hash_state(moved.raw_state()) == hash_state(stayed.raw_state()));
}

TEST_CASE("after a million substeps the clock is exact", "[simulation]") {
    Simulation simulation = simulation_of(free_fall(), 0);
    for (int i = 0; i < 125000; ++i) {
        simulation.step();  // 8 substeps without a ball cost nothing
    }
    CHECK(simulation.time() == 1000000.0 * (1.0 / 60.0 / 8.0));
    CHECK(simulation.step_count() == 125000);
}

TEST_CASE("the step length comes from the settings alone", "[simulation]") {
    // The trap: a step as long as the last frame took. However late a step comes, it is the same step.
    Simulation simulation = simulation_of(free_fall(), 1);
    const SubstepParams<double> params = simulation.params();
    CHECK(params.drift == 1.0 / 60.0 / 8.0);
    simulation.step();
    CHECK(simulation.time() == 8.0 * (1.0 / 60.0 / 8.0));
}

TEST_CASE("synchronised velocities are those of the position's time", "[simulation]") {
    for (const Integrator integrator : {Integrator::leapfrog, Integrator::velocity_verlet}) {
        Scene scene = free_fall();
        scene.settings.integrator = integrator;
        // The reference in double, whose sums stay below the rounding of the float that it hands out.
        Simulation simulation(scene, scene.settings, 0, std::make_unique<cpu::CpuBackend<double>>());
        for (int i = 1; i <= 60; ++i) {
            simulation.step();
            const vec4 velocity = simulation.synchronised_state().velocities[0];
            CHECK(velocity.z == static_cast<float>(3.0 - 9.8 * simulation.time()));
        }
        // Not so the raw ones: they stand half a substep behind.
        CHECK(simulation.raw_state().velocity_lag == Approx(0.5 / 480.0).epsilon(1e-12));
    }
}

TEST_CASE("two listed balls at the same place part without a NaN and keep their momentum", "[simulation]") {
    // The trap: normalising a zero vector.
    Scene scene = test::shipped_scene("two_balls");
    scene.balls[0].position = scene.balls[1].position = {0.25, 0.5, -0.125};
    scene.balls[0].velocity = scene.balls[1].velocity = {0, 0, 0};
    Simulation simulation = simulation_of(scene, 2);
    run(simulation, 1);
    const BallState state = simulation.synchronised_state();
    const vec3 apart = vec3(state.positions[0]) - vec3(state.positions[1]);
    CHECK(glm::length(apart) > 0.01f);
    const vec3 momentum = vec3(state.velocities[0]) + vec3(state.velocities[1]);
    CHECK(momentum == vec3(0.0f));
    CHECK(read_slot<Status>(simulation.backend(), Slot::status)[0].not_finite == 0);
}
