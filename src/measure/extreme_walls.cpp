// Walls and those who are beyond them, wider than them, or caught between them.
#include <algorithm>
#include <cmath>

#include "measure/extreme_rows.h"

namespace ballpit::measure {

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
