// A25: the forces that the grid finds are those of comparing every ball with every other.
#include <algorithm>
#include <cmath>

#include "support/analytic_scene.h"
#include "support/brute_force.h"
#include "support/catch.h"
#include "support/substep_setup.h"

namespace ballpit::test {

namespace {

// Balls in one cell lie hundreds deep in one another: what rounding explains grows with the forces.
void check_forces(const Machine& machine, Placement placement, std::uint32_t count, const Grid& grid, SortMethod sort) {
    const BallState state = placed_balls(placement, count);
    Settings settings;
    settings.integrator = Integrator::symplectic_euler;
    const auto setup = setup_for(state, contact_features(), sort, settings, grid);
    const auto backend = machine.make();
    run_all(*backend, state, setup);
    const auto next = read_slot<vec4>(*backend, Slot::next_velocities);
    const double dt = settings.dt / settings.substeps;
    const auto expected =
        brute_force_substep(state, setup.schedule.features, setup.settings, dvec3(box_half_extent), dt);
    dvec3 change(0.0);
    double scale = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto mass = static_cast<double>(state.velocities[i].w);
        const double force = expected[i].force_scale + settings.stiffness * 1e-6 * expected[i].contacts;
        CAPTURE(placement_names[static_cast<std::size_t>(placement)], count, i, expected[i].contacts);
        if (expected[i].coincident) {
            continue;  // their direction is a matter of definition; that it is opposite, the sum tells
        }
        REQUIRE(glm::length(dvec3(next[i]) - expected[i].velocity) <= 2e-6 * (1.0 + force * dt / mass * 10.0));
        change += mass * (dvec3(next[i]) - dvec3(state.velocities[i]));
        scale += mass * glm::length(dvec3(state.velocities[i])) + expected[i].force_scale * dt;
    }
    CHECK(glm::length(change) <= 1e-6 * scale);
}

}  // namespace

void a25_neighbours(const Machine& machine) {
    for (const Placement placement : placements) {
        for (const std::uint32_t count : {0u, 1u, 2u, 63u, 64u, 65u, 127u, 1000u}) {
            for (const Grid& grid :
                 {dyadic_grid(), make_grid(dvec3(box_half_extent), static_cast<double>(usual_radius), 1.0, count)}) {
                for (const SortMethod sort : {SortMethod::bitonic_fused, SortMethod::counting}) {
                    check_forces(machine, placement, count, grid, sort);
                }
            }
        }
    }
}

// The cells that a scene of unequal balls gets: with those of the mean radius 1.5 in 100 contacts would be missed.
void a25_grid_of_a_scene(const Machine& machine) {
    const BallState state = placed_balls(Placement::radii_1_to_4, 1000);
    std::vector<BallSpec> balls;
    for (std::size_t i = 0; i < state.count(); ++i) {
        balls.push_back(ball(dvec3(state.positions[i]), {}, static_cast<double>(state.positions[i].w)));
    }
    Scene scene = scene_of(balls, Integrator::symplectic_euler, 1e-3);
    scene.half_extent = dvec3(box_half_extent);
    scene.settings.laws.contact = true;
    const Motion found = motion_after(machine, scene, 1e-3);
    scene.settings.neighbours = NeighbourSearch::brute_force;
    const Motion expected = motion_after(machine, scene, 1e-3);
    for (std::size_t i = 0; i < found.v.size(); ++i) {
        CAPTURE(i);
        CHECK(glm::length(found.v[i] - expected.v[i]) <= machine.tolerance(1e-12, 1e-5));
    }
}

}  // namespace ballpit::test
