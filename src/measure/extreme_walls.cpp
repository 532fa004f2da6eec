// Walls and those who are beyond them, wider than them, or caught between them.
#include <algorithm>
#include <cmath>

#include "measure/extreme_rows.h"

namespace ballpit::measure {

void outside_the_box(ExtremeTrial& trial) {
    Scene scene = extreme_scene("contact,walls", 2.0);
    scene.settings.substeps = 16;
    put_ball(scene, {0, 0, -7}, {0, 0, 0});
    Simulation simulation = trial.start(scene);
    // The wall keeps the force of one diameter, 0.2 m: what it can give the ball on its way back.
    const double given = 1000.0 * 0.2 * (5.1 - 0.1);
    double fastest = 0.0;
    double highest = -7.0;
    double most = 0.0;
    for (int step = 0; step < 120; ++step) {
        run_steps(simulation, 1);
        const BallState state = simulation.synchronised_state();
        const Totals totals = totals_of(simulation);
        fastest = std::max(fastest, static_cast<double>(glm::length(vec3(state.velocities[0]))));
        highest = std::max(highest, static_cast<double>(state.positions[0].z));
        most = std::max(most, totals.kinetic + totals.elastic);
    }
    trial.at_least("5 m outside: comes back to z =", highest, -2.0, " m");
    trial.near("at most", fastest, std::sqrt(2.0 * given), 0.01, " m/s");
    trial.near("energy at most", most, given, 0.01, " J");
    trial.expect_sign(simulation, "out_of_bounds");
    trial.expect_sign(simulation, "capped_walls");
}

void larger_than_the_box(ExtremeTrial& trial) {
    Scene scene = extreme_scene("gravity,walls,restitution", 1.0);
    scene.settings.restitution = 0.2;
    put_ball(scene, {0, 0, 0.1}, {0, 0, 0}, 1.5);
    Simulation simulation = trial.start(scene);
    run_steps(simulation, 600);
    const BallState state = simulation.synchronised_state();
    // Two walls of stiffness k hold it: m g = 2 k z.
    trial.near("radius 1.5 m in a box of 1 m: rests at", static_cast<double>(state.positions[0].z), -9.8 / 2000.0, 1e-3,
               " m");
    trial.at_most("speed left", static_cast<double>(glm::length(vec3(state.velocities[0]))), 1e-4, " m/s");
    trial.expect_sign(simulation, "ball_larger_than_box");
}

void walls_closing_in(ExtremeTrial& trial) {
    Scene scene = extreme_scene("contact,restitution,walls", 1.0);
    scene.settings.restitution = 0.5;
    scene.settings.stiffness = 1e4;
    scene.settings.substeps = 16;
    fill_region(scene, 200, {0.08, 0.08}, 0.5, dvec3(-0.9), dvec3(0.9));
    Simulation simulation = trial.start(scene);
    run_steps(simulation, 5);
    Settings settings = simulation.settings();
    settings.walls_low = dvec3(0.4);  // at one blow, as a slider would
    settings.walls_high = dvec3(-0.4);
    simulation.change(settings);
    double fastest = 0.0;
    for (int step = 0; step < 60; ++step) {
        run_steps(simulation, 1);
        fastest = std::max(fastest, metered(simulation).reading.max_speed);
    }
    const Totals totals = totals_of(simulation);
    trial.near("half a box's width after 1 s", simulation.box().upper.x, 0.6, 1e-6, " m");
    trial.at_most("fastest ball", fastest, 10.0, " m/s");
    trial.at_most("largest overlap", totals.max_overlap, 0.08, " m");
    trial.expect(all_finite(simulation.raw_state()), "all finite");
    trial.note_signs(simulation);
}

}  // namespace ballpit::measure
