// The threaded path against the mirror: the same bits in every buffer, whatever a scene models.
#include "cpu/threaded_backend.h"

#include <array>
#include <atomic>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/simulation.h"
#include "support/backend_contract.h"
#include "support/catch.h"
#include "support/extreme_contract.h"
#include "support/scenes.h"
#include "support/stage_contract.h"

using namespace ballpit;

namespace {

std::unique_ptr<Backend> threads(unsigned count = 3) { return std::make_unique<cpu::ThreadedBackend>(count); }

// The first slot whose bytes differ, or nothing.
std::string difference(Simulation& a, Simulation& b) {
    for (std::size_t slot = 0; slot < slot_count; ++slot) {
        if (a.backend().read(static_cast<Slot>(slot)) != b.backend().read(static_cast<Slot>(slot))) {
            return std::string(slot_names[slot]);
        }
    }
    return "";
}

// Runs both and compares all that they hold after every substep.
void runs_alike(
    const Scene& scene, const Settings& settings, int substeps,
    const std::function<void(Simulation&)>& prepare = [](Simulation&) {}) {
    const std::uint64_t seed = test::seed_of(scene);
    Simulation mirror(scene, settings, seed, std::make_unique<cpu::CpuBackend<float>>());
    Simulation threaded(scene, settings, seed, threads());
    for (Simulation* simulation : {&mirror, &threaded}) {
        prepare(*simulation);
    }
    for (int i = 0; i < substeps; ++i) {
        mirror.substep();
        threaded.substep();
        CAPTURE(i);
        REQUIRE(difference(mirror, threaded).empty());
    }
}

Settings rain_with(const Scene& scene, std::span<const std::array<std::string_view, 2>> changes) {
    Settings settings = scene.settings;
    settings.balls = 900;
    for (const auto& [key, value] : changes) {
        assign_setting(settings, key, value);
    }
    return settings;
}

}  // namespace

TEST_CASE("every scene has the mirror's bits on threads", "[threads]") {
    for (const std::string_view name : test::shipped_scene_names) {
        CAPTURE(name);
        const Scene scene = test::shipped_scene(name);
        runs_alike(scene, scene.settings, 40);
    }
}

TEST_CASE("every choice has the mirror's bits on threads", "[threads]") {
    using Changes = std::vector<std::array<std::string_view, 2>>;
    const std::vector<Changes> choices = {
        {},
        {{"integrator", "symplectic_euler"}},
        {{"integrator", "velocity_verlet"}},
        {{"integrator", "forward_euler"}},
        {{"integrator", "historical"}},
        {{"sort", "bitonic"}},
        {{"neighbours", "brute_force"}},
        {{"grid_reuse", "3"}, {"cell_factor", "1.2"}},
        {{"grid_reuse", "2"}, {"laws", "gravity,contact,restitution,walls,diagnostics,unequal_radii,unequal_masses"}},
        {{"cell_factor", "0.5"}},
        {{"cell_factor", "8"}},
        {{"restitution", "1"}},
        {{"limit_force", "false"}},
        {{"dashpot", "semi_implicit"}},
        {{"laws", "gravity,drag,contact,restitution,walls,compensated"}},
        {{"laws", "gravity,drag,walls,restitution"}},
        {{"laws", "gravity"}},
        {{"pull", "17,0,0,5"}},
        {{"walls_high", "-1,-1,-1"}, {"wall_speed", "5"}},
        {{"balls", "1"}},
        {{"balls", "0"}},
    };
    const Scene scene = test::shipped_scene("rain");
    for (const Changes& changes : choices) {
        const std::string text =
            changes.empty() ? "as it is" : std::string(changes[0][0]) + "=" + std::string(changes[0][1]);
        CAPTURE(text);
        runs_alike(scene, rain_with(scene, changes), 30);
    }
}

TEST_CASE("odd balls have the mirror's bits on threads", "[threads]") {
    constexpr float infinite = std::numeric_limits<float>::infinity();
    const Scene scene = test::shipped_scene("rain");
    const Settings counted = rain_with(
        scene, std::array<std::array<std::string_view, 2>, 1>{
                   {{"laws", "gravity,drag,contact,restitution,walls,diagnostics,unequal_radii,unequal_masses"}}});
    const auto spoil = [](Slot slot, std::size_t ball, const vec4& value) {
        return [=](Simulation& simulation) {
            auto values = read_slot<vec4>(simulation.backend(), slot);
            values[ball] = value;
            simulation.backend().write(slot, std::as_bytes(std::span(values)));
        };
    };
    const auto coincide = [](Simulation& simulation) {
        auto positions = read_slot<vec4>(simulation.backend(), Slot::positions);
        positions[7] = positions[300];
        positions[8] = positions[300];
        simulation.backend().write(Slot::positions, std::as_bytes(std::span(positions)));
    };
    runs_alike(scene, counted, 5, spoil(Slot::velocities, 5, {infinite, 0, 0, 1}));
    runs_alike(scene, counted, 5, spoil(Slot::positions, 6, {std::nanf(""), 0, 0, 0.15f}));
    runs_alike(scene, counted, 5, spoil(Slot::velocities, 6, {1.8e19f, 5e18f, 0, 1}));
    runs_alike(scene, counted, 5, spoil(Slot::positions, 9, {50, 0, 0, 0.15f}));
    runs_alike(scene, counted, 5, coincide);
    runs_alike(scene, rain_with(scene, {}), 5, coincide);
}

TEST_CASE("the threaded path keeps a backend's promises", "[threads]") {
    cpu::ThreadedBackend backend(3);
    test::reads_what_was_loaded(backend);
    test::reads_what_was_written(backend);
    test::buffers_grow_and_shrink(backend);
    test::reschedules_in_the_middle(backend);
    test::times_every_stage(backend);
    test::status_adds_up(backend);
    test::saves_and_restores(backend);
    test::works_in_place(backend);
    test::collides_like_brute_force(backend, std::array{0u, 1u, 2u, 63u, 65u, 500u});
}

TEST_CASE("the threaded path meets the extremes as the mirror does", "[threads]") {
    const auto three = [] { return threads(); };
    test::quarantine_leaves_the_others_alone(three);
    test::walls_push_no_harder_than_their_cap(three);
    test::coincident_balls_are_counted(three);
    test::too_fast_balls_are_counted(three);
    test::no_time_changes_no_bit(three);
}

TEST_CASE("who steps from dispatch to dispatch sees the mirror's buffers", "[threads]") {
    const Scene scene = test::shipped_scene("rain");
    const Settings settings = rain_with(scene, {});
    Simulation mirror(scene, settings, 1, std::make_unique<cpu::CpuBackend<float>>());
    Simulation threaded(scene, settings, 1, threads());
    mirror.substep();
    threaded.substep();  // a whole one first: what it leaves behind must not be in the way
    const std::size_t dispatches = mirror.schedule().dispatches.size();
    for (std::size_t i = 0; i < dispatches; ++i) {
        for (Simulation* simulation : {&mirror, &threaded}) {
            simulation->backend().run(simulation->schedule(), simulation->params(), i, i + 1);
        }
        CAPTURE(i);
        REQUIRE(difference(mirror, threaded).empty());
    }
}

TEST_CASE("workers do each task once, again and again", "[threads]") {
    cpu::Workers workers(4);
    CHECK(workers.threads() == 4);
    for (std::uint32_t count : {0u, 1u, 2u, 3u, 4u, 5u, 100u, 1000u}) {
        std::vector<int> done(count, 0);
        for (int round = 0; round < 50; ++round) {
            workers.run(count, [&](std::uint32_t task) { ++done[task]; });
        }
        CHECK(done == std::vector<int>(count, 50));
    }
}

TEST_CASE("a task that fails fails its loop, and the workers go on", "[threads]") {
    cpu::Workers workers(3);
    const auto fail = [](std::uint32_t task) {
        if (task == 5) {
            throw std::runtime_error("five");
        }
    };
    for (int round = 0; round < 20; ++round) {
        CHECK_THROWS_AS(workers.run(20, fail), std::runtime_error);
    }
    std::atomic<int> done = 0;
    workers.run(20, [&](std::uint32_t) { ++done; });
    CHECK(done == 20);
}
