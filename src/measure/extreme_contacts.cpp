// Two balls, or very many, at what a contact can be asked for.
#include <algorithm>
#include <cmath>

#include "measure/extreme_rows.h"
#include "measure/warnings.h"

namespace ballpit::measure {

namespace {

struct Two {
    vec3 apart{0.0f};     // m
    dvec3 momentum{0.0};  // kg m/s
};

Two two_of(Simulation& simulation) {
    const BallState state = simulation.raw_state();
    const dvec3 first = static_cast<double>(state.velocities[0].w) * dvec3(state.velocities[0]);
    const dvec3 second = static_cast<double>(state.velocities[1].w) * dvec3(state.velocities[1]);
    return {vec3(state.positions[1]) - vec3(state.positions[0]), first + second};
}

// Head-on along x, centres 1 m apart; k / mu = 20000 1/s^2, D = 0.2 m: the energy would carry them through each other
// above D sqrt(k / mu) = 28.28 m/s between them.
Scene head_on(double speed) {
    Scene scene = extreme_scene("contact", 4.0);
    scene.settings.stiffness = 1e4;
    scene.settings.dt = 1e-3;
    scene.settings.substeps = 1;
    put_ball(scene, {-0.5, 0, 0}, {speed, 0, 0});
    put_ball(scene, {0.5, 0, 0}, {-speed, 0, 0});
    return scene;
}

}  // namespace

void coincident_centres(ExtremeTrial& trial) {
    Scene scene = extreme_scene("contact", 2.0);
    put_ball(scene, {0, 0, 0}, {0, 0, 0});
    put_ball(scene, {0, 0, 0}, {0, 0, 0});
    Simulation simulation = trial.start(scene);
    run_steps(simulation, 10);
    const BallState state = simulation.raw_state();
    trial.at_least("apart after 10 steps", static_cast<double>(glm::length(two_of(simulation).apart)), 0.2, " m");
    trial.at_most("sum of momenta", glm::length(two_of(simulation).momentum), 0.0, " kg m/s");
    trial.expect(vec3(state.positions[0]) == -vec3(state.positions[1]), "places mirror each other bit for bit");
    Simulation again = trial.start(scene);
    run_steps(again, 10);
    trial.expect(hash_of(again) == hash_of(simulation), "the same direction each time");
    trial.expect_sign(simulation, "coincident");

    for (int i = 0; i < 30; ++i) {
        put_ball(scene, {0, 0, 0}, {0, 0, 0});
    }
    Simulation many = trial.start(scene);
    run_steps(many, 10);
    const Totals totals = totals_of(many);
    trial.expect(all_finite(many.raw_state()), "32 in one place: all finite");
    trial.at_most("their momentum over the sum of all", glm::length(totals.momentum) / std::sqrt(64.0 * totals.kinetic),
                  1e-5);
}

void all_in_one_cell(ExtremeTrial& trial) {
    Scene scene = extreme_scene("contact,restitution", 4.0);
    scene.settings.restitution = 0.5;
    scene.settings.substeps = 4;
    put_ball(scene, {3, 3, 3}, {0, 0, 0}, 0.5);  // makes the cells 1 m wide
    fill_region(scene, 500, {0.02, 0.1}, 0.5, dvec3(0.2), dvec3(0.8));
    Simulation grid = trial.start(scene);
    const NeighbourReport report = grid_report(trial, grid);
    trial.expect(report.missed.empty(), digits(report.contacts) + " pairs found of " +
                                            digits(report.contacts + static_cast<double>(report.missed.size())));
    trial.at_least("pairs tested", static_cast<double>(report.tested), 500.0 * 499.0);
    scene.settings.neighbours = NeighbourSearch::brute_force;
    Simulation brute = trial.start(scene);
    brute.substep();
    trial.expect(hash_of(grid) == hash_of(brute), "after a substep the same bits as brute force");
    trial.expect_no_sign(grid, "over_capacity");
}

void zero_stiffness(ExtremeTrial& trial) {
    for (const char* laws : {"contact,walls", "contact,restitution,walls"}) {
        Scene scene = extreme_scene(laws, 4.0);
        scene.settings.stiffness = 0.0;
        scene.settings.restitution = 0.5;
        put_ball(scene, {-0.5, 0.01, 0}, {2, 0, 0});
        put_ball(scene, {0.5, 0, 0}, {-2, 0, 0});
        Simulation simulation = trial.start(scene);
        run_steps(simulation, 60);
        const BallState state = simulation.raw_state();
        trial.expect(vec3(state.velocities[0]) == vec3(2, 0, 0) && vec3(state.velocities[1]) == vec3(-2, 0, 0),
                     std::string(laws) + ": velocities keep every bit");
        trial.at_most("way apart after 1 s against -3 m",
                      std::abs(static_cast<double>(two_of(simulation).apart.x) + 3.0), 1e-4, " m");
        bool numbers = true;
        for (const Gauge& gauge : gauges(metered(simulation), simulation)) {
            numbers = numbers && !std::isnan(gauge.value);
        }
        trial.require(numbers, "a gauge divides 0 by 0");
        trial.note_signs(simulation);
    }
}

void tunnelling(ExtremeTrial& trial) {
    for (const auto& [speed, bounces] : {std::pair(14.0, true), std::pair(14.2, false), std::pair(400.0, false)}) {
        const Scene scene = head_on(speed);
        Simulation simulation = trial.start(scene);
        run_steps(simulation, speed > 100.0 ? 4 : 150);
        trial.expect((two_of(simulation).apart.x > 0.0f) == bounces,
                     "at 2 x " + digits(speed) + " m/s they " + (bounces ? "bounce" : "pass"));
        trial.note_signs(simulation);
    }
    Simulation fast = trial.start(head_on(400.0));
    run_steps(fast, 4);
    trial.expect_sign(fast, "too_fast");
    Simulation slow = trial.start(head_on(5.0));
    run_steps(slow, 100);
    trial.expect_no_sign(slow);
}

void deep_overlap(ExtremeTrial& trial) {
    Scene scene = extreme_scene("contact,walls", 2.0);
    scene.settings.stiffness = 1e5;
    scene.settings.substeps = 16;
    put_ball(scene, {-0.005, 0, 0}, {0, 0, 0});
    put_ball(scene, {0.005, 0, 0}, {0, 0, 0});
    for (const bool relaxed : {false, true}) {
        Simulation simulation = trial.start(scene);
        const double stored = stored_in_overlaps(simulation.synchronised_state(), simulation.settings(),
                                                 simulation.features(), simulation.box());
        trial.near("stored at the start", stored, 0.5 * 1e5 * 0.19 * 0.19, 1e-5, " J");
        trial.note({"initial_overlap", stored});
        if (relaxed) {
            simulation.apply(Relax{});
            trial.at_most("relaxed, stored", totals_of(simulation).elastic, 1e-5 * stored, " J");
        }
        run_steps(simulation, 2);
        const double fastest = metered(simulation).reading.max_speed;
        if (relaxed) {
            trial.at_most("then they part at", fastest, 0.5, " m/s");
        } else {
            trial.near("let go, they part at", fastest, std::sqrt(stored), 0.01, " m/s");
        }
    }
}

void overdamped(ExtremeTrial& trial) {
    // At rest on the floor: h = omega dt = 1, zeta = 1.95 where the force is limited; explicit dashpots go to h = 0.48.
    Scene scene = extreme_scene("gravity,walls,restitution", 2.0);
    scene.settings.stiffness = 1e4;
    scene.settings.restitution = 0.05;
    scene.settings.dt = 0.01;
    scene.settings.substeps = 1;
    put_ball(scene, {0, 0, -1.9}, {0, 0, 0});
    for (const char* dashpot : {"explicit", "semi_implicit"}) {
        assign_setting(scene.settings, "dashpot", dashpot);
        Simulation simulation = trial.start(scene);
        double fastest = 0.0;
        for (int step = 0; step < 1000; ++step) {
            run_steps(simulation, 1);
            fastest = std::max(fastest, metered(simulation).reading.max_speed);
        }
        if (std::string_view(dashpot) == "explicit") {
            trial.at_least("explicit, fastest", fastest, 1.0, " m/s");
            trial.expect_sign(simulation, "explicit_dashpot_limit");
        } else {
            trial.at_most("semi-implicit, fastest", fastest, 0.1, " m/s");
            trial.at_most("after 10 s", metered(simulation).reading.max_speed, 1e-4, " m/s");
            trial.expect_no_sign(simulation, "explicit_dashpot_limit");
        }
    }
}

}  // namespace ballpit::measure
