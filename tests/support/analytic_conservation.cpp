// A27 and A28: what runs backwards must come back, and what is conserved must stay.
#include <cmath>
#include <numbers>

#include "support/analytic_scene.h"
#include "support/catch.h"

namespace ballpit::test {

namespace {

using std::numbers::pi;

double root_mean_square(const std::vector<dvec3>& a, const std::vector<dvec3>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += glm::dot(a[i] - b[i], a[i] - b[i]);
    }
    return std::sqrt(sum / static_cast<double>(a.size()));
}

// There and back. The reference runs backwards by a negative dt, because its state can only be loaded in float.
double return_error(const Machine& machine, Integrator integrator, double dt, int substeps, std::uint32_t count) {
    Scene scene = gas_scene(integrator, dt, count);
    Simulation there = start(machine, scene);
    const std::vector<dvec3> begin = positions_of(there);
    run(there, substeps);
    if (machine.rounding == 0.0) {
        Settings back = there.settings();
        back.dt = -dt;
        there.change(back);
        run(there, substeps);
        return root_mean_square(begin, positions_of(there));
    }
    const BallState turned = there.synchronised_state();
    scene.fill.reset();
    for (std::uint32_t i = 0; i < turned.count(); ++i) {
        scene.balls.push_back(ball(dvec3(turned.positions[i]), -dvec3(turned.velocities[i]),
                                   static_cast<double>(turned.positions[i].w),
                                   static_cast<double>(turned.velocities[i].w)));
    }
    return root_mean_square(begin, motion_after(machine, scene, substeps * dt).x);
}

struct Sums {
    dvec3 momentum{0.0};
    dvec3 angular{0.0};
    double scale = 0.0;
};

Sums sums_of(const Motion& motion) {
    Sums sums;
    for (std::size_t i = 0; i < motion.x.size(); ++i) {
        sums.momentum += motion.v[i];
        sums.angular += glm::cross(motion.x[i], motion.v[i]);
        sums.scale += glm::length(motion.v[i]);
    }
    return sums;
}

}  // namespace

void a27_time_reversal(const Machine& machine) {
    constexpr std::uint32_t count = 150;
    constexpr double diameter = 2.0 * gas_radius;
    const double dt = pi / std::sqrt(2.0 * gas_stiffness) / 36.0;
    const int substeps = substeps_in(0.3, dt);
    for (const Integrator integrator : {Integrator::leapfrog, Integrator::velocity_verlet}) {
        if (machine.slow && integrator == Integrator::velocity_verlet) {
            continue;
        }
        const double error = return_error(machine, integrator, dt, substeps, count);
        CAPTURE(integrator_names[static_cast<std::size_t>(integrator)], error / diameter);
        CHECK(error <= machine.tolerance(2e-12, 3e-3) * diameter);
    }
    // Not a matter of rounding: the historical integrator is no map that goes back.
    CHECK(return_error(machine, Integrator::historical, dt, substeps / 3, count) >= 0.1 * diameter);
}

void a28_conservation(const Machine& machine) {
    const double dt = pi / std::sqrt(2.0 * gas_stiffness) / 36.0;
    Scene scene = gas_scene(Integrator::leapfrog, dt, 300);
    scene.settings.laws.walls = false;
    Simulation simulation = start(machine, scene);
    const Sums before = sums_of(motion_of(simulation));
    run(simulation, 1000);
    const Sums after = sums_of(motion_of(simulation));
    const double momentum = glm::length(after.momentum - before.momentum) / before.scale;
    const double angular = glm::length(after.angular - before.angular) / before.scale;
    CAPTURE(momentum, angular);
    CHECK(momentum <= machine.tolerance(1e-14, 2e-7));
    CHECK(angular <= machine.tolerance(1e-7, 3e-6));
    CHECK(std::abs(after.scale / before.scale - 1.0) > 1e-3);  // they did collide
}

}  // namespace ballpit::test
