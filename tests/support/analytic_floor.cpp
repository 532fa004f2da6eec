// A6, A9 and A12: a ball on the floor, under gravity.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/analytic_scene.h"
#include "support/catch.h"
#include "support/oracle.h"

namespace ballpit::test {

namespace {

using std::numbers::pi;

constexpr double g = 9.8;

std::string_view name_of(Integrator integrator) { return integrator_names[static_cast<std::size_t>(integrator)]; }

double height_over_floor(const Scene& scene, std::size_t i) {
    return stored(scene.balls[i].position.z) + drop_depth - stored(0.1);
}

}  // namespace

void a6_bounces_on_the_floor(const Machine& machine) {
    REQUIRE(bouncing(1.0, 100.0, g, 1.0).first + 0.1 == Approx(1.07953028713).epsilon(1e-10));
    REQUIRE(bouncing(1.0, 100.0, g, 5.0).second == Approx(-3.16704267482).epsilon(1e-10));
    REQUIRE(bouncing(1.0, 100.0, g, 10.0).first + 0.1 == Approx(0.69065862787).epsilon(1e-10));
    for (const int n : {30, 121}) {
        const double dt = 1.0 / substeps_in(n, pi / wall_frequency);  // a whole number of substeps in 1 s
        for (const Integrator integrator : every_integrator) {
            if (integrator == Integrator::forward_euler) {
                continue;
            }
            const Scene scene = drop_scene(integrator, dt);
            const Motion end = motion_after(machine, scene, 1.0);
            double worst = 0.0;
            for (std::size_t i = 0; i < 16; ++i) {
                const double height = height_over_floor(scene, i);
                const double reached = end.x[i].z + drop_depth - stored(0.1);
                const double error = reached - bouncing(height, wall_frequency, g, 1.0).first;
                worst = std::max(worst, std::abs(error));
                const SpringContact floor{canonical_stiffness, 1.0, 0.0, true, -g};
                DiscreteLine line{height, 0.0, 0.0};
                for (int step = 0; step < substeps_in(1.0, dt); ++step) {
                    line.step(integrator, dt, 0.0, floor);
                }
                CAPTURE(n, name_of(integrator), i);
                CHECK(std::abs(reached - line.x) <= machine.tolerance(1e-9, 2e-4));
            }
            CAPTURE(n, name_of(integrator), worst * n, worst * n * n);
            const double rounding = machine.tolerance(1e-7, 2e-4);
            // e - 1 is at most h^2 / 8 (docs/accuracy.md), at 4.43 m/s and for the half second after the bounce.
            const double square = 2.9 / (n * n) + rounding;
            switch (integrator) {
                case Integrator::symplectic_euler:
                    CHECK(worst <= square + 0.012 / n);
                    break;
                case Integrator::historical:
                    CHECK(worst <= 1.1 * 6.0 / n);
                    CHECK(worst >= 0.7 * 6.0 / n);
                    break;
                default:
                    CHECK(worst <= square);
            }
        }
    }
}

void a6_touch_and_depth(const Machine& machine) {
    constexpr double dt = 1e-4;
    Simulation simulation = start(machine, drop_scene(Integrator::leapfrog, dt));
    Scene scene = drop_scene(Integrator::leapfrog, dt);
    double depth = 0.0;
    double touched = 0.0;
    double left = 0.0;
    // Ball 8 starts 1.000625 m over the floor; the table is for 1 m, where speeds differ by 1/3200.
    const double height = height_over_floor(scene, 8);
    for (int i = 1; i <= 5000; ++i) {
        simulation.substep();
        const double gap = positions_of(simulation)[8].z + drop_depth - stored(0.1);
        depth = std::max(depth, -gap);
        touched += gap < 0.0 && touched == 0.0 ? i * dt : 0.0;
        left = gap < 0.0 ? i * dt : left;
    }
    const double more = std::sqrt(height);
    const double rounding = machine.tolerance(0.0, 2e-5);
    CHECK(touched == Approx(0.4517539515 * more).margin(1.01 * dt + rounding));
    CHECK(left - touched + dt == Approx(0.03185857312).margin(1.01 * dt + rounding));
    CHECK(depth * canonical_stiffness == Approx(452.6273253 * more).epsilon(1e-4));
}

void a9_static_overlap(const Machine& machine) {
    struct Row {
        double half_extent, tolerance;
    };
    for (const Row& row : {Row{1.0, 1.2e-7}, Row{100.0, 1.53e-5}}) {  // two ulp of a position at the wall
        for (const Integrator integrator : every_integrator) {
            // c = 20 N s/m is zeta = 0.1; c > k dt, so that even forward Euler comes to rest.
            Scene scene = wall_scene({ball({0, 0, 0.1 - row.half_extent}, {})}, integrator, 1.0 / 1920.0);
            scene.half_extent = dvec3(row.half_extent);
            scene.settings.laws.gravity = scene.settings.laws.restitution = true;
            scene.settings.restitution = exact_restitution(0.1, true);
            const Motion end = motion_after(machine, scene, 3.0);
            CAPTURE(row.half_extent, name_of(integrator));
            const double overlap = stored(0.1) - (end.x[0].z + row.half_extent);
            CHECK(std::abs(overlap - g / canonical_stiffness) <= machine.tolerance(1e-12, row.tolerance));
        }
    }
}

void a12_oscillation_in_contact(const Machine& machine) {
    struct Row {
        double h, ratio;
    };
    constexpr double half_extent = 0.125;  // the floor is where floats are fine
    const double sag = g / canonical_stiffness;
    const double middle = stored(0.1) - half_extent - sag;
    for (const Row& row : {Row{.1, 1.000417136}, Row{.2, 1.001674212}, Row{.5, 1.010721021}}) {
        const double numeric = 2.0 * std::asin(row.h / 2.0) / row.h;
        REQUIRE(numeric == Approx(row.ratio).epsilon(1e-9));
        const double dt = row.h / wall_frequency;
        for (const Integrator integrator : {Integrator::leapfrog, Integrator::velocity_verlet}) {
            Scene scene = wall_scene({ball({0, 0, middle + 0.5 * sag}, {})}, integrator, dt);
            scene.half_extent = dvec3(half_extent);
            scene.settings.laws.gravity = true;
            Simulation simulation = start(machine, scene);
            const double amplitude = stored(middle + 0.5 * sag) - middle;
            double worst = 0.0;
            for (int step = 1; step <= 10000; ++step) {
                simulation.substep();
                if (step > 200 && step % 997 > 20) {
                    continue;  // some twenty samples in a row, now and then
                }
                const double z = positions_of(simulation)[0].z - middle;
                worst = std::max(worst, std::abs(z - amplitude * std::cos(numeric * row.h * step)) / amplitude);
            }
            // x = A cos, v = -A w sqrt(1 - h^2 / 4) sin: the ellipse on which these integrators stay.
            const Motion end = motion_of(simulation);
            const double across = end.v[0].z / (wall_frequency * std::sqrt(1.0 - 0.25 * row.h * row.h));
            const double kept = std::hypot(end.x[0].z - middle, across) / amplitude;
            CAPTURE(row.h, name_of(integrator), worst, kept);
            CHECK(worst <= machine.tolerance(1e-7, 5e-3));
            CHECK(std::abs(kept - 1.0) <= machine.tolerance(1e-7, 1e-3));
        }
    }
    // The historical integrator grows by the root of 1 + h^2 / 2 a substep.
    constexpr double h = 0.1;
    Scene scene = wall_scene({ball({0, 0, middle + sag / 64.0}, {})}, Integrator::historical, h / wall_frequency);
    scene.half_extent = dvec3(half_extent);
    scene.settings.laws.gravity = true;
    Simulation simulation = start(machine, scene);
    const double amplitude = stored(middle + sag / 64.0) - middle;
    const SpringContact floor{canonical_stiffness, 1.0, 0.0, true, -g};
    DiscreteLine line{-sag + amplitude, 0.0, 0.0};
    const int steps = 1000;
    run(simulation, steps);
    for (int step = 0; step < steps; ++step) {
        line.step(Integrator::historical, h / wall_frequency, 0.0, floor);
    }
    const Motion end = motion_of(simulation);
    // Energy in the invariant of that map, x^2 + (h/2) x v/w + ..., is not needed: one period averages it out.
    const double radius = std::hypot(end.x[0].z - middle, end.v[0].z / wall_frequency);
    CHECK(radius / amplitude == Approx(std::pow(1.0 + 0.5 * h * h, 0.5 * steps)).epsilon(0.06));
    CHECK(end.x[0].z - middle == Approx(line.x + sag).margin(machine.tolerance(1e-9, 1e-3) * sag));
}

}  // namespace ballpit::test
