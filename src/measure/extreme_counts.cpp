// Counts of balls that groups and powers of two do not like, and balls of very unequal size.
#include <array>
#include <cmath>

#include "measure/extreme_rows.h"
#include "measure/pairs.h"

namespace ballpit::measure {

namespace {

// What the grid finds against every pair compared with every other, not against the cells of touching_pairs().
std::string missed_pairs(ExtremeTrial& trial, const Scene& scene) {
    Simulation simulation = trial.start(scene);
    run_steps(simulation, 2);
    const std::size_t all = brute_force_pairs(simulation.raw_state().positions).size();
    const NeighbourReport report = grid_report(trial, simulation);
    trial.require(report.missed.empty() && report.contacts == all,
                  digits(report.contacts) + " pairs found, " + digits(static_cast<double>(all)) + " there are");
    trial.require(all > scene.settings.balls / 8, "too few pairs to tell");
    return digits(static_cast<double>(all)) + " pairs, all found";
}

Scene dense(std::uint32_t balls, const std::array<double, 2>& radius, double half_extent) {
    Scene scene = extreme_scene("contact,restitution,walls", half_extent);
    scene.settings.restitution = 0.7;
    fill_region(scene, balls, radius, 1.0, dvec3(-half_extent), dvec3(half_extent));
    return scene;
}

}  // namespace

void few_balls(ExtremeTrial& trial) {
    for (const std::uint32_t balls : {0u, 1u, 2u}) {
        Scene scene = extreme_scene("gravity,drag,contact,restitution,walls", 1.0);
        scene.settings.restitution = 0.5;
        fill_region(scene, balls, {0.1, 0.2}, 1.0, dvec3(-1.0), dvec3(1.0));
        Simulation simulation = trial.start(scene);
        run_steps(simulation, 30);
        const MeterRecord record = metered(simulation);
        const Totals totals = totals_of(simulation);
        const double sum = totals.kinetic + totals.potential + totals.elastic + record.reading.energy() +
                           record.reading.mean_overlap_share() + record.reading.max_speed;
        trial.expect(std::isfinite(sum) && all_finite(simulation.raw_state()),
                     std::to_string(balls) + " balls: kinetic energy " + digits(totals.kinetic) + " J");
        trial.require(simulation.raw_state().count() == balls && simulation.step_count() == 30, "balls or steps lost");
    }
}

void odd_counts(ExtremeTrial& trial) {
    for (const auto& [balls, half] :
         {std::pair(63u, 0.5), std::pair(64u, 0.5), std::pair(65u, 0.5), std::pair(4097u, 2.0)}) {
        Scene scene = dense(balls, {0.08, 0.12}, half);
        scene.settings.sort = SortMethod::bitonic;
        const std::string first = missed_pairs(trial, scene);
        scene.settings.sort = SortMethod::bitonic_fused;
        const std::string second = missed_pairs(trial, scene);
        trial.expect(first == second, std::to_string(balls) + " balls: " + first);
    }
}

void unequal_radii(ExtremeTrial& trial) {
    for (const double largest : {0.08, 2.0}) {
        Scene scene = dense(1000, {0.02, 0.025}, largest > 1.0 ? 2.5 : 0.2);
        if (largest > 1.0) {  // in front of the large ball's face, so that many small ones touch it
            scene.fill->region = {dvec3(1.9, -0.3, -0.3), dvec3(2.1, 0.3, 0.3)};
        }
        put_ball(scene, {0, 0, 0}, {0, 0, 0}, largest, 1e3);
        const std::string pairs = missed_pairs(trial, scene);
        trial.expect(pairs.ends_with("all found"), "radii 1:" + digits(largest / 0.02) + ": " + pairs);
    }
    Scene scene = dense(500, {0.02, 0.08}, 0.4);
    scene.settings.cell_factor = 0.3;
    Simulation narrow = trial.start(scene);
    run_steps(narrow, 2);
    const NeighbourReport report = grid_report(trial, narrow);
    trial.at_least("cells 0.3 of the diameter: missed", static_cast<double>(report.missed.size()), 1.0);
    trial.expect_sign(narrow, "cell_too_small");
}

}  // namespace ballpit::measure
