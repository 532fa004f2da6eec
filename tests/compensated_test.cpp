// Compensated sums: what is kept beside the balls, and that it is kept through everything a user does.
#include <memory>

#include "core/error.h"
#include "core/ledger.h"
#include "core/scene_schedule.h"
#include "core/simulation.h"
#include "cpu/cpu_backend.h"
#include "measure/check.h"
#include "support/catch.h"
#include "support/law_scenes.h"

using namespace ballpit;

namespace {

// The mirror on a device that has no more than OpenGL guarantees.
struct SmallDevice final : cpu::CpuBackend<float> {
    StorageLimits storage_limits() const override { return {8, 8}; }
};

Settings with_law(Settings settings, bool compensated) {
    settings.laws.compensated = compensated;
    return settings;
}

Simulation running(const std::string& laws, int steps = 5) {
    const Scene scene = test::scene_with(laws, 60);
    Simulation simulation(scene, scene.settings, 3, std::make_unique<cpu::CpuBackend<float>>());
    for (int i = 0; i < steps; ++i) {
        simulation.step();
    }
    return simulation;
}

bool same(const Compensation& a, const Compensation& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z && a.vx == b.vx && a.vy == b.vy && a.vz == b.vz;
}

Compensation left_out(const dvec3& position, const dvec3& velocity) {
    const vec3 x(position - dvec3(vec3(position)));
    const vec3 v(velocity - dvec3(vec3(velocity)));
    return {x.x, x.y, x.z, v.x, v.y, v.z};
}

}  // namespace

TEST_CASE("a scene with compensated sums starts where it says, to the last digit of a double", "[compensated]") {
    Scene scene = test::scene_with("gravity,compensated", 2);
    scene.balls = {{{0.1, 0.2, 0.3}, {0.7, -1.1, 0}, 0.08, 1.0, std::nullopt}};
    Simulation simulation(scene, scene.settings, 3, std::make_unique<cpu::CpuBackend<float>>());
    const Compensation kept = simulation.raw_state().compensations.at(0);
    CHECK(same(kept, left_out({0.1, 0.2, 0.3}, {0.7, -1.1, 0})));
    CHECK(kept.x == static_cast<float>(0.1 - static_cast<double>(0.1f)));
    CHECK(kept.x != 0.0f);
    CHECK(kept.vz == 0.0f);
}

TEST_CASE("what is left out is at most half a unit in the last place", "[compensated]") {
    for (const char* laws : {"gravity,drag,walls,compensated", "gravity,contact,restitution,walls,compensated"}) {
        Simulation simulation = running(laws);
        const BallState state = simulation.raw_state();
        REQUIRE(state.compensations.size() == 60);
        int other_than_0 = 0;
        for (std::size_t i = 0; i < 60; ++i) {
            const Compensation& left = state.compensations[i];
            CAPTURE(laws, i);
            CHECK(state.positions[i].x + left.x == state.positions[i].x);
            CHECK(state.positions[i].z + left.z == state.positions[i].z);
            CHECK(state.velocities[i].z + left.vz == state.velocities[i].z);
            other_than_0 += left.z != 0.0f && left.vz != 0.0f ? 1 : 0;
        }
        CHECK(other_than_0 > 40);
    }
}

TEST_CASE("the law keeps 24 bytes a ball, and nothing where it is off", "[compensated]") {
    for (const char* laws : {"gravity", "gravity,contact,restitution,walls,diagnostics"}) {
        const Scene scene = test::scene_with(laws, 64);
        const Schedule off = first_schedule(scene);
        Scene with = scene;
        with.settings.laws.compensated = true;
        const Schedule on = first_schedule(with);
        CAPTURE(laws);
        CHECK(bytes_per_ball(on) == bytes_per_ball(off) + 24.0);
        CHECK(bound_slots(on).size() == bound_slots(off).size() + 1);
        CHECK(on.dispatches.size() == off.dispatches.size());
        CHECK(on.in_place == off.in_place);
        Simulation simulation = running(laws, 1);
        CHECK(simulation.raw_state().compensations.empty());
    }
}

TEST_CASE("a ball that is thrown in starts where it is put, and the others keep what they have left out",
          "[compensated]") {
    Simulation simulation = running("gravity,contact,restitution,walls,compensated");
    const BallState before = simulation.synchronised_state();
    simulation.apply(AddBalls{{{{0.1, 0.2, 0.3}, {1.1, 2, 3}, 0.15, 4.0, std::nullopt}}});
    const BallState after = simulation.raw_state();
    REQUIRE(after.compensations.size() == 61);
    for (std::size_t i = 0; i < 60; ++i) {
        CHECK(same(after.compensations[i], before.compensations[i]));
    }
    CHECK(same(after.compensations[60], left_out({0.1, 0.2, 0.3}, {1.1, 2, 3})));
    Settings settings = simulation.settings();
    settings.balls = 30;
    simulation.change(settings);
    CHECK(same(simulation.raw_state().compensations.at(29), before.compensations[29]));
    settings.balls = 62;  // those that come back begin anew
    simulation.change(settings);
    CHECK(same(simulation.raw_state().compensations.at(29), before.compensations[29]));
    CHECK(simulation.raw_state().compensations.size() == 62);
}

TEST_CASE("looking at synchronised velocities leaves no trace in what is left out", "[compensated]") {
    for (const char* laws : {"gravity,drag,walls,compensated", "gravity,contact,restitution,walls,compensated"}) {
        Simulation simulation = running(laws);
        const BallState before = simulation.raw_state();
        const BallState synchronised = simulation.synchronised_state();
        const BallState after = simulation.raw_state();
        CAPTURE(laws);
        int differing = 0;
        for (std::size_t i = 0; i < before.count(); ++i) {
            CHECK(same(before.compensations[i], after.compensations[i]));
            differing += same(before.compensations[i], synchronised.compensations[i]) ? 0 : 1;
        }
        CHECK(differing > 30);
    }
}

TEST_CASE("switched on, nothing has been left out so far; switched off, nothing is kept", "[compensated]") {
    Simulation simulation = running("gravity,contact,walls");
    simulation.change(with_law(simulation.settings(), true));
    for (const Compensation& left : simulation.raw_state().compensations) {
        CHECK(same(left, {}));
    }
    CHECK(simulation.raw_state().compensations.size() == 60);
    simulation.step();
    simulation.change(with_law(simulation.settings(), false));
    CHECK(simulation.raw_state().compensations.empty());
}

TEST_CASE("a device without room for one more buffer refuses the law and goes on", "[compensated]") {
    for (const char* laws : {"gravity", "gravity,contact,restitution,walls,diagnostics,ball_restitution"}) {
        const Scene scene = test::scene_with(laws, 60);
        Simulation simulation(scene, scene.settings, 3, std::make_unique<SmallDevice>());
        simulation.step();
        const std::uint64_t before = hash_state(simulation.raw_state());
        CAPTURE(laws);
        std::string sentence;
        try {
            simulation.change(with_law(simulation.settings(), true));
        } catch (const DeviceError& error) {
            sentence = error.what();
        }
        CHECK(sentence ==
              "collide would need 9 buffers at once, the device allows 8 a shader: switch off the law 'compensated' "
              "(Compensated sums)");
        CHECK_FALSE(simulation.settings().laws.compensated);
        CHECK(hash_state(simulation.raw_state()) == before);
        simulation.step();
        CHECK(hash_state(simulation.raw_state()) != before);
        CHECK_THROWS_AS(simulation.load(scene, with_law(scene.settings, true), 3), DeviceError);
        CHECK(simulation.step_count() == 2);
    }
}

TEST_CASE("a device is asked for as many buffers as a dispatch binds", "[compensated]") {
    Scene scene = test::scene_with("gravity,contact,restitution,walls,diagnostics,ball_restitution,compensated", 60);
    const Schedule all = first_schedule(scene);
    CHECK_NOTHROW(expect_storage(all, {9, 9}));
    CHECK_THROWS_AS(expect_storage(all, {8, 96}), DeviceError);
    CHECK_THROWS_AS(expect_storage(all, {96, 8}), DeviceError);
    scene.settings.laws.diagnostics = false;
    CHECK_NOTHROW(expect_storage(first_schedule(scene), {8, 9}));
    scene.settings.laws = parse_laws("gravity,contact,restitution,walls,diagnostics,ball_restitution");
    CHECK_NOTHROW(expect_storage(first_schedule(scene), {8, 8}));
}
