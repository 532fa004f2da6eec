// Numbers at the ends of float: large ones, and steps of no or hardly any time.
#include <cmath>

#include "measure/extreme_rows.h"

namespace ballpit::measure {

namespace {

Scene crowd() {
    Scene scene = extreme_scene("contact,restitution,walls", 2.0);
    scene.settings.restitution = 0.8;
    fill_region(scene, 64, {0.1, 0.2}, 1.0, dvec3(-1.0), dvec3(1.0));
    return scene;
}

Scene resting(double half_extent, double substep) {
    Scene scene = extreme_scene("gravity,walls,restitution", half_extent);
    scene.settings.stiffness = 1e4;
    scene.settings.restitution = 0.3;
    scene.settings.substeps = 16;
    scene.settings.dt = 16.0 * substep;
    put_ball(scene, {0, 0, 0.0999 - half_extent}, {0, 0, 0});
    return scene;
}

}  // namespace

void no_time(ExtremeTrial& trial) {
    Scene scene = crowd();
    scene.settings.laws = parse_laws("gravity,drag,contact,restitution,walls,diagnostics");
    put_ball(scene, {0.5, -0.0, 0.0}, {-0.0, 0.0, -0.0}, 0.15);
    Simulation simulation = trial.start(scene);
    run_steps(simulation, 5);
    // Velocities to the positions' time first: with no time between them, they will not lag again.
    Settings still = simulation.settings();
    still.dt = 0.0;
    simulation.change(still);
    run_steps(simulation, 1);
    const std::uint64_t before = hash_of(simulation);
    const double time = simulation.time();
    const std::vector<ExtremeSign> signs = signs_of(simulation);
    run_steps(simulation, 20);
    trial.expect(hash_of(simulation) == before, "20 steps of dt = 0: the same bits");
    trial.expect(simulation.time() == time, "time stands still");
    trial.expect(signs_of(simulation) == signs, "nothing is counted");
    bool refused = false;
    try {
        assign_setting(still, "dt", "-0.01");
    } catch (const std::exception&) {
        refused = true;
    }
    trial.expect(refused, "dt < 0 refused");
}

void drag_beyond_two(ExtremeTrial& trial) {
    Scene scene = extreme_scene("drag", 4.0);
    scene.settings.drag = 100.0;
    scene.settings.integrator = Integrator::symplectic_euler;
    scene.settings.substeps = 1;
    scene.settings.dt = 0.1;
    put_ball(scene, {0, 0, 0}, {1, -1, 2});
    Simulation simulation = trial.start(scene);
    for (int n = 1; n <= 3; ++n) {
        run_steps(simulation, 1);
        const vec4 velocity = simulation.raw_state().velocities[0];
        trial.near("speed after " + std::to_string(n), static_cast<double>(velocity.x), std::exp(-10.0 * n), 1e-5,
                   " m/s");
        trial.require(velocity.y < 0.0f && velocity.z > 0.0f, "a direction flips");
    }
    trial.note_signs(simulation);
}

void large_coordinates(ExtremeTrial& trial) {
    for (const double half : {10.0, 100.0, 1e4}) {
        const Scene scene = resting(half, 1.0 / 960);
        Simulation simulation = trial.start(scene);
        run_steps(simulation, 120);
        const double overlap = totals_of(simulation).max_overlap;
        const double error = std::abs(overlap / (9.8 / 1e4) - 1.0);
        const bool warned = has_sign(simulation, "float_floor");
        trial.expect(error < 0.02 || warned, "box of " + digits(half) + " m: rests " + digits(overlap) +
                                                 " m deep (exact " + digits(9.8e-4) + ")" +
                                                 (warned ? ", and is warned of" : ""));
        trial.note_signs(simulation);
    }
}

void a_million_steps_of_the_clock(ExtremeTrial& trial) {
    Scene scene = extreme_scene("none", 1.0);
    scene.settings.dt = 1.0 / 960;
    scene.settings.substeps = 1;
    fill_region(scene, 0, {0.1, 0.1}, 0.0, dvec3(-1.0), dvec3(1.0));
    Simulation simulation = trial.start(scene);
    run_steps(simulation, 1000000);
    trial.at_most("off after 1e6 steps of 1/960 s", std::abs(simulation.time() - 1e6 / 960), 1e-9, " s");
    trial.require(simulation.step_count() == 1000000, "steps are missing");
}

void tiny_substep(ExtremeTrial& trial) {
    for (const char* laws : {"none", "compensated"}) {
        Scene scene = extreme_scene(laws, 128.0);
        scene.settings.dt = 1e-3;
        scene.settings.substeps = 100;
        put_ball(scene, {100, 0, 0}, {0.3, 0, 0});
        Simulation simulation = trial.start(scene);
        run_steps(simulation, 20);
        const double way = static_cast<double>(simulation.raw_state().positions[0].x) - 100.0;
        const bool right = std::abs(way / (0.3 * 0.02) - 1.0) < 0.01;
        const bool warned = has_sign(simulation, "tiny_dt");
        trial.expect(right || warned, (std::string_view(laws) == "none" ? std::string("plain") : laws) + ": moves " +
                                          digits(way) + " m of 0.006" +
                                          (right    ? ""
                                           : warned ? ", and is warned of"
                                                    : " in silence"));
        trial.require(right || std::string_view(laws) == "none", "compensated sums leave something out");
        trial.note_signs(simulation);
    }
}

}  // namespace ballpit::measure
