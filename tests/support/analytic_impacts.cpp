// A4 and A5: two balls meet head on.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/analytic_scene.h"
#include "support/catch.h"
#include "support/oracle.h"

namespace ballpit::test {

namespace {

using std::numbers::pi;

const BallSpec from_left = ball({}, {1, 0, 0});
const BallSpec from_right = ball({}, {-1, 0, 0});

Settings settings_of(Integrator integrator, double dt) { return scene_of({}, integrator, dt).settings; }

struct Discrete {
    double restitution, max_overlap;
};

// The relative motion of a pair is that of one ball of the reduced mass against a wall.
Discrete discrete_collision(Integrator integrator, double dt, const Collision& c, int steps) {
    const SpringContact spring{canonical_stiffness, c.left.mass * c.right.mass / (c.left.mass + c.right.mass)};
    const double closing = c.left.velocity.x - c.right.velocity.x;
    DiscreteLine gap{c.right.position.x - c.left.position.x - c.left.radius - c.right.radius, -closing, 0.0};
    Discrete result{0.0, 0.0};
    for (int i = 0; i < steps; ++i) {
        gap.step(integrator, dt, 0.0, spring);
        result.max_overlap = std::max(result.max_overlap, -gap.x);
    }
    result.restitution = gap.synchronised(0.0, spring) / closing;
    return result;
}

void check_head_on(const Machine& machine, int n, Integrator integrator) {
    const double contact = pi / pair_frequency;
    const double dt = contact / n;
    const double rounding = machine.rounding * 3e-5;
    const int steps = 2 * n + 8;
    double mean_duration = 0.0;
    for (const Collision& c :
         collide(machine, settings_of(integrator, dt), at_64_phases(from_left, from_right), steps)) {
        const Discrete discrete = discrete_collision(integrator, dt, c, steps);
        const double gain = c.restitution - 1.0;
        CAPTURE(integrator_names[static_cast<std::size_t>(integrator)], n, c.restitution, discrete.restitution);
        CHECK(std::abs(c.restitution - discrete.restitution) <= machine.tolerance(1e-11, 3e-5));
        CHECK(std::abs(c.max_overlap - discrete.max_overlap) <= machine.tolerance(1e-11, 1e-6));
        CHECK(std::abs(c.v[0].x + c.v[1].x) <= machine.tolerance(1e-13, 4 * 1.2e-7));
        if (integrator == Integrator::historical) {
            if (n >= 20) {
                CHECK(gain == Approx(std::exp(pi * pi / (4.0 * n)) - 1.0).epsilon(0.02));
            }
        } else if (integrator == Integrator::forward_euler) {
            if (n >= 20) {
                CHECK(gain == Approx(std::exp(pi * pi / (2.0 * n)) - 1.0).epsilon(0.08));
            }
        } else {
            CHECK(std::abs(gain) <= 2.1 / (n * n * n) + rounding);
            CHECK(std::abs(c.max_overlap / 0.01414213562 - 1.0) <= 1.24 / (n * n) + rounding);
            CHECK(std::abs(c.duration - contact * (1.0 - 0.411 / (n * n))) <= 1.01 * dt);
            mean_duration += c.duration / 64.0;
        }
    }
    if (mean_duration > 0.0) {  // over all phases the samples in contact tell the duration itself
        CAPTURE(integrator_names[static_cast<std::size_t>(integrator)], n, mean_duration / contact);
        CHECK(mean_duration / contact == Approx(1.0 - 0.411 / (n * n)).margin(1.0 / (64.0 * n)));
    }
}

}  // namespace

void a4_head_on(const Machine& machine) {
    for (const int n : {8, 20, 50}) {
        for (const Integrator integrator : every_integrator) {
            check_head_on(machine, n, integrator);
        }
    }
}

// The bound 2.1 / n^3 is that of whole n. In between, the shares a and b of the first and the last substep that lie
// within the contact do not add up to 1, and e - 1 = h^2 / 2 (b (1 - b) - a (1 - a)), at most h^2 / 8
// (docs/accuracy.md).
void a4_contact_of_no_whole_number_of_substeps(const Machine& machine) {
    for (const double n : {10.5, 21.3, 40.5}) {
        const double dt = pi / pair_frequency / n;
        double worst = 0.0;
        for (const Collision& c : collide(machine, settings_of(Integrator::leapfrog, dt),
                                          at_64_phases(from_left, from_right), static_cast<int>(2.0 * n) + 8)) {
            worst = std::max(worst, std::abs(c.restitution - 1.0));
        }
        CAPTURE(n, worst * n * n);
        CHECK(worst <= pi * pi / 8.0 / (n * n) * 1.02 + machine.rounding * 3e-5);
        CHECK(worst >= 0.3 / (n * n));
    }
}

void a5_unequal_balls(const Machine& machine) {
    constexpr int n = 50;
    constexpr double contact = 0.02961921959;
    constexpr double displaced = 0.003291024399;  // of both, while they touch
    const double dt = contact / n;
    const int steps = 2 * n + 8;
    for (const Integrator integrator : symplectic) {
        for (const Collision& c : collide(machine, settings_of(integrator, dt),
                                          at_64_phases(ball({}, {1, 0, 0}), ball({}, {}, 0.2, 8.0)), steps)) {
            CAPTURE(integrator_names[static_cast<std::size_t>(integrator)], c.restitution);
            const double rounding = machine.rounding * 3e-5;
            const Discrete discrete = discrete_collision(integrator, dt, c, steps);
            CHECK(std::abs(c.restitution - discrete.restitution) <= machine.tolerance(1e-11, 3e-5));
            CHECK(std::abs(c.restitution - 1.0) <= 2.1 / (n * n * n) + rounding);
            CHECK(std::abs(c.v[0].x + 7.0 / 9.0) <= 2.1 / (n * n * n) + rounding);
            CHECK(std::abs(c.v[1].x - 2.0 / 9.0) <= 2.1 / (n * n * n) + rounding);
            CHECK(c.v[0].x + 8.0 * c.v[1].x == Approx(1.0).epsilon(machine.tolerance(1e-13, 3e-6)));
            CHECK(c.max_overlap == Approx(0.009428090416).epsilon(1.24 / (n * n) + rounding));
            CHECK(std::abs(c.duration - contact) <= 1.01 * dt);
            // Where they are afterwards tells by how much they moved in contact.
            const double touched = -(c.left.position.x - c.right.position.x + 0.3);
            const double after = c.time - touched - contact;
            const double left = c.left.position.x + touched + displaced - 7.0 / 9.0 * after;
            const double right = c.right.position.x + displaced + 2.0 / 9.0 * after;
            const double shorter = 0.5 / (n * n) * contact + 2.1 / (n * n * n) * after;
            CHECK(std::abs(c.x[0].x - left) <= shorter + machine.tolerance(1e-7, 2e-6));
            CHECK(std::abs(c.x[1].x - right) <= shorter + machine.tolerance(1e-7, 2e-6));
        }
    }
}

}  // namespace ballpit::test
