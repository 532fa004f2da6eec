// A6 once more: the ball drop with sums that are compensated, beside sums that are not.
#include <algorithm>
#include <cmath>

#include "support/analytic_scene.h"
#include "support/catch.h"
#include "support/oracle.h"

namespace ballpit::test {

namespace {

constexpr double g = 9.8;

// m by which rounding moved a ball in its first second, the largest of all. The oracle has the same integrator and the
// same constants, as the machine rounds them: what is left is what the sums have lost.
double rounding_of_drops(const Machine& machine, bool compensated, Integrator integrator, int n) {
    const double dt = 1.0 / (60.0 * n);
    Scene scene = drop_scene(integrator, dt);
    scene.settings.laws.compensated = compensated;
    Simulation simulation = start(machine, scene);
    run(simulation, 60 * n);
    const BallState end = simulation.raw_state();
    const auto constant = [&](double value) { return machine.rounding == 0.0 ? value : stored(value); };
    const SpringContact floor{canonical_stiffness, 1.0, 0.0, true, -constant(g)};
    const double up = drop_depth - stored(0.1);  // from the middle of the box to the floor, for the lowest point
    double worst = 0.0;
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        const double z = scene.balls[i].position.z;
        DiscreteLine line{(compensated ? z : stored(z)) + up, 0.0, 0.0};
        for (int step = 0; step < 60 * n; ++step) {
            line.step(integrator, constant(dt), 0.0, floor);
        }
        const double left = compensated ? static_cast<double>(end.compensations[i].z) : 0.0;
        worst = std::max(worst, std::abs(static_cast<double>(end.positions[i].z) + left + up - line.x));
    }
    return worst;
}

}  // namespace

void a6_with_compensated_sums(const Machine& machine) {
    for (const Integrator integrator : symplectic) {
        for (const int n : machine.slow ? std::vector{64} : std::vector{64, 1024, 4096}) {
            const double plain = rounding_of_drops(machine, false, integrator, n);
            const double compensated = rounding_of_drops(machine, true, integrator, n);
            CAPTURE(n, integrator_names[static_cast<std::size_t>(integrator)], plain, compensated);
            CHECK(compensated <= 1e-7);  // the reference's is that of its position, handed out in float
            CHECK(plain >= machine.tolerance(0.0, 1e-5));
        }
    }
}

}  // namespace ballpit::test
