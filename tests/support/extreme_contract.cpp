#include "support/extreme_contract.h"

#include <cmath>
#include <limits>

#include "core/simulation.h"
#include "measure/energy.h"
#include "support/catch.h"
#include "support/law_scenes.h"

namespace ballpit::test {

namespace {

constexpr float nan_number = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

Simulation start(const Scene& scene, const BackendMaker& make) { return {scene, scene.settings, 3, make()}; }

Status status_of(Simulation& simulation) { return read_slot<Status>(simulation.backend(), Slot::status).front(); }

void write_balls(Simulation& simulation, const BallState& state) {
    simulation.backend().write(Slot::positions, std::as_bytes(std::span(state.positions)));
    simulation.backend().write(Slot::velocities, std::as_bytes(std::span(state.velocities)));
}

void run_steps(Simulation& simulation, int steps) {
    for (int i = 0; i < steps; ++i) {
        simulation.step();
    }
}

// Alone in a box, as a saved moment has it: that may be outside.
Scene lone_ball(std::string_view laws, const dvec3& position, const dvec3& velocity) {
    Scene scene = scene_with(laws, 1);
    scene.settings.balls = 1;
    scene.fill.reset();
    scene.balls = {{position, velocity, 0.1, 1.0, std::nullopt}};
    scene.settings.stiffness = 1e4;
    scene.settings.restitution = 1.0;
    scene.settings.substeps = 16;
    scene.resume = Resume{};
    return scene;
}

double mechanical(Simulation& simulation) {
    const measure::Totals totals = measure::totals_of(simulation.synchronised_state(), simulation.settings(),
                                                      simulation.features(), simulation.box());
    return totals.kinetic + totals.elastic;
}

}  // namespace

void quarantine_leaves_the_others_alone(const BackendMaker& make) {
    for (const char* laws : {"gravity,contact,restitution,walls,diagnostics",
                             "gravity,contact,restitution,walls,diagnostics,compensated,unequal_radii"}) {
        CAPTURE(laws);
        const Scene scene = scene_with(laws, 200);
        Simulation injured = start(scene, make);
        Simulation ghosts = start(scene, make);
        run_steps(injured, 5);
        run_steps(ghosts, 5);
        BallState state = injured.raw_state();
        BallState ghost = state;
        state.velocities[17].y = nan_number;
        state.positions[40].x = nan_number;
        state.velocities[41].z = -infinity;
        state.velocities[90].x = 1e30f;
        for (const std::size_t ball : {17u, 40u, 41u, 90u}) {
            ghost.positions[ball].w = -ghost.positions[ball].w;
            ghost.velocities[ball] = vec4(vec3(0.0f), ghost.velocities[ball].w);
        }
        write_balls(injured, state);
        write_balls(ghosts, ghost);
        run_steps(injured, 5);
        run_steps(ghosts, 5);
        const Status status = status_of(injured);
        CHECK(status.not_finite == 4);
        CHECK(status.quarantined_ball == 91);
        CHECK(status_of(ghosts).not_finite == 0);
        const BallState after = injured.raw_state();
        BallState expected = ghosts.raw_state();
        CHECK(after.positions[40] == vec4(static_cast<float>(injured.box().lower.x), ghost.positions[40].y,
                                          ghost.positions[40].z, ghost.positions[40].w));
        expected.positions[40].x = after.positions[40].x;
        CHECK(hash_state(after) == hash_state(expected));
    }
}

void walls_push_no_harder_than_their_cap(const BackendMaker& make) {
    for (const char* laws : {"walls,diagnostics", "contact,walls,diagnostics"}) {
        CAPTURE(laws);
        const Scene scene = lone_ball(laws, {0.0, 0.0, -5.9}, dvec3(0.0));  // 5 m deep
        Simulation simulation = start(scene, make);
        const double stored = mechanical(simulation);
        CHECK(stored == Approx(1e4 * 0.2 * (5.0 - 0.1)));  // k depth (overlap - depth / 2), depth a diameter
        bool came_back = false;
        for (int i = 0; i < 600; ++i) {
            simulation.substep();
            const BallState state = simulation.synchronised_state();
            CHECK(std::abs(static_cast<double>(state.velocities[0].z)) <= 1.02 * std::sqrt(2.0 * stored));
            came_back = came_back || std::abs(state.positions[0].z) < 0.9f;
        }
        CHECK(came_back);
        CHECK(mechanical(simulation) == Approx(stored).epsilon(0.02));
        CHECK(status_of(simulation).capped_walls > 20);
    }
}

void coincident_balls_are_counted(const BackendMaker& make) {
    Scene scene = lone_ball("contact,restitution,diagnostics", {0.1, 0.2, 0.3}, dvec3(0.0));
    scene.balls.push_back(scene.balls.front());
    scene.settings.balls = 2;
    Simulation simulation = start(scene, make);
    simulation.substep();
    CHECK(status_of(simulation).coincident == 1);
    for (int i = 0; i < 50; ++i) {
        const BallState state = simulation.raw_state();
        CHECK(vec3(state.velocities[0]) + vec3(state.velocities[1]) == vec3(0.0f));
        simulation.substep();
    }
    CHECK(status_of(simulation).coincident == 1);
    CHECK(simulation.raw_state().positions[0] != simulation.raw_state().positions[1]);
}

void too_fast_balls_are_counted(const BackendMaker& make) {
    Scene scene = lone_ball("walls,diagnostics", dvec3(0.0), {0.0, 0.0, 97.0});
    scene.half_extent = dvec3(100.0);
    Simulation simulation = start(scene, make);
    run_steps(simulation, 1);
    CHECK(status_of(simulation).too_fast == 16);
    Scene slower = scene;
    slower.balls[0].velocity.z = 95.0;  // 0.1 m take 1 / 960 s at 96 m/s
    Simulation slow = start(slower, make);
    run_steps(slow, 1);
    CHECK(status_of(slow).bits == 0);
}

void no_time_changes_no_bit(const BackendMaker& make) {
    for (const char* laws : {"gravity,drag,diagnostics", "gravity,contact,restitution,walls,diagnostics"}) {
        CAPTURE(laws);
        Scene scene = scene_with(laws, 70);
        scene.settings.dt = 0.0;
        Simulation simulation = start(scene, make);
        BallState state = simulation.raw_state();
        state.positions[3].x = -0.0f;
        state.velocities[3] = vec4(-0.0f, -0.0f, -0.0f, state.velocities[3].w);
        state.positions[4].x = 7.0f;  // outside
        write_balls(simulation, state);
        const auto before = hash_state(state);
        run_steps(simulation, 3);
        CHECK(hash_state(simulation.raw_state()) == before);
        CHECK(status_of(simulation).bits == 0);
        CHECK(simulation.time() == 0.0);
        CHECK(simulation.step_count() == 3);
    }
}

void semi_implicit_dashpots_hold(const BackendMaker& make) {
    Scene scene = lone_ball("gravity,walls,restitution,diagnostics", {0.0, 0.0, -0.85}, dvec3(0.0));
    scene.settings.restitution = 0.05;  // zeta 1.95
    scene.settings.gravity = dvec3(0.0, 0.0, -9.8);
    scene.settings.substeps = 1;
    scene.settings.dt = 0.012;  // h = 1.2, the explicit limit is 0.48
    Simulation exact = start(scene, make);
    scene.settings.dashpot = DashpotMethod::semi_implicit;
    Simulation held = start(scene, make);
    run_steps(exact, 400);
    run_steps(held, 400);
    const float rest = -0.9f - static_cast<float>(9.8 / 1e4);
    CHECK(std::abs(held.raw_state().positions[0].z - rest) < 2e-6f);
    CHECK(std::abs(exact.raw_state().positions[0].z - rest) > 1e-3f);

    Scene pair = lone_ball("contact,restitution,diagnostics", {-0.15, 0.01, 0.0}, {8.0, 0.0, 0.0});
    pair.balls.push_back({{0.1, 0.0, 0.02}, dvec3(0.0), 0.1, 7.0, std::nullopt});
    pair.settings.balls = 2;
    pair.settings.restitution = 0.05;
    pair.settings.substeps = 4;
    pair.settings.dashpot = DashpotMethod::semi_implicit;
    Simulation two = start(pair, make);
    run_steps(two, 20);
    const BallState state = two.synchronised_state();
    const dvec3 momentum = dvec3(state.velocities[0]) + 7.0 * dvec3(state.velocities[1]);
    CHECK(glm::distance(momentum, dvec3(8.0, 0.0, 0.0)) < 1e-5);
    CHECK(state.velocities[1].x > 0.5f);
}

void relaxing_parts_balls(const BackendMaker& make) {
    Scene scene = scene_with("gravity,contact,restitution,walls,diagnostics", 120);
    scene.fill->region = {dvec3(-0.2), dvec3(0.2)};
    scene.fill->speed = 0.5;
    Simulation simulation = start(scene, make);
    run_steps(simulation, 0);
    const auto elastic = [&] {
        return measure::totals_of(simulation.raw_state(), simulation.settings(), simulation.features(),
                                  simulation.box())
            .elastic;
    };
    const BallState state = simulation.raw_state();
    const double before = elastic();
    REQUIRE(before > 10.0);
    simulation.apply(Relax{});
    CHECK(elastic() < 1e-4 * before);
    CHECK(simulation.raw_state().velocities == state.velocities);
    CHECK(simulation.raw_state().positions != state.positions);
    CHECK(simulation.time() == 0.0);
    CHECK(status_of(simulation).not_finite == 0);
    const BallState relaxed = simulation.raw_state();
    Simulation again = start(scene, make);
    again.apply(Relax{});
    CHECK(hash_state(again.raw_state()) == hash_state(relaxed));
}

}  // namespace ballpit::test
