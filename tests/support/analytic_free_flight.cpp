// A1 to A3: gravity and drag, nothing to touch.
#include <algorithm>
#include <cmath>

#include "support/analytic_scene.h"
#include "support/catch.h"
#include "support/oracle.h"

namespace ballpit::test {

namespace {

constexpr double g = 9.8;
constexpr double drag = 0.1;

Scene drag_scene(const BallSpec& thrown, Integrator integrator, double dt) {
    Scene scene = scene_of({thrown}, integrator, dt);
    scene.settings.laws.gravity = scene.settings.laws.drag = true;
    scene.settings.drag = drag;
    return scene;
}

// In float the factor of a substep, a little below 1, is off by up to 2^-25, each time the same way: after n substeps a
// path of 10 m is off by n 2^-25 10 m. The smaller the substep, the worse.
double rounding_of_drag(const Machine& machine, int substeps) {
    return machine.tolerance(1e-11, 10.0 * substeps * std::ldexp(1.0, -25));
}

struct Throw {
    double x, v;
};

// dv/dt = a - drag v, in closed form.
Throw with_drag(double v0, double a, double t) {
    const double limit = a / drag;
    return {limit * t + (v0 - limit) * (1.0 - std::exp(-drag * t)) / drag, limit + (v0 - limit) * std::exp(-drag * t)};
}

Throw discrete_with_drag(Integrator integrator, double v0, double a, double dt, int steps) {
    DiscreteLine line{0.0, v0, 0.0};
    const auto acceleration = [a](double, double) { return a; };
    for (int i = 0; i < steps; ++i) {
        line.step(integrator, dt, drag, acceleration);
    }
    return {line.x, line.synchronised(drag, acceleration)};
}

}  // namespace

void a1_free_fall(const Machine& machine) {
    for (const double dt : {1.0 / 60.0, 1.0 / 960.0}) {
        for (const Integrator integrator : every_integrator) {
            Scene scene = scene_of({ball({0, 0, 10}, {1, -2, 3})}, integrator, dt);
            scene.settings.laws.gravity = true;
            scene.settings.substeps = 4;  // a step of four substeps of dt
            scene.settings.dt = 4.0 * dt;
            Simulation simulation = start(machine, scene);
            const int steps = substeps_in(1.0, dt);
            run(simulation, steps);
            const Motion end = motion_of(simulation);
            // The Euler integrators see the speed of one end of each substep: half a substep of fall too much or
            // too little.
            const double lag = integrator == Integrator::symplectic_euler ? -0.5
                               : integrator == Integrator::forward_euler  ? 0.5
                                                                          : 0.0;
            const double z = 8.1 + lag * g * dt;
            constexpr double ulp = 9.5367431640625e-7;  // of a float from 8 to 16
            const double tolerance = machine.tolerance(1e-12, 20.0 * ulp * std::sqrt(steps));
            CAPTURE(integrator_names[static_cast<std::size_t>(integrator)], dt, z);
            CHECK(std::abs(end.x[0].z - z) <= tolerance);
            CHECK(std::abs(end.x[0].x - 1.0) <= tolerance);
            CHECK(std::abs(end.x[0].y + 2.0) <= tolerance);
            CHECK(std::abs(end.v[0].z + 6.8) <= tolerance);
            CHECK(end.v[0].x == 1.0);
            CHECK(end.v[0].y == -2.0);
            CHECK(simulation.time() == Approx(1.0).epsilon(1e-14));
        }
    }
}

void a2_projectile_with_drag(const Machine& machine) {
    const BallSpec thrown = ball({}, {5, 0, 10});
    const Throw across = with_drag(5.0, 0.0, 2.0);
    const Throw up = with_drag(10.0, -g, 2.0);
    REQUIRE(across.x == Approx(9.063462346).epsilon(1e-9));
    REQUIRE(up.x == Approx(-0.2292133242).epsilon(1e-9));
    REQUIRE(across.v == Approx(4.093653765).epsilon(1e-9));
    REQUIRE(up.v == Approx(-9.577078668).epsilon(1e-9));
    for (const double dt : {1.0 / 60.0, 1.0 / 240.0, 1.0 / 960.0}) {
        const int steps = substeps_in(2.0, dt);
        const double exact = rounding_of_drag(machine, steps);
        for (const Integrator integrator : every_integrator) {
            const Motion end = motion_after(machine, drag_scene(thrown, integrator, dt), 2.0);
            const Throw x = discrete_with_drag(integrator, 5.0, 0.0, dt, steps);
            const Throw z = discrete_with_drag(integrator, 10.0, -g, dt, steps);
            CAPTURE(integrator_names[static_cast<std::size_t>(integrator)], dt, end.x[0].z);
            CHECK(std::abs(end.x[0].x - x.x) <= exact);
            CHECK(std::abs(end.x[0].z - z.x) <= exact);
            // The drag factor is exact, and so are the velocities of all of them.
            CHECK(std::abs(end.v[0].x - across.v) <= exact);
            CHECK(std::abs(end.v[0].z - up.v) <= exact);
            const double error = std::abs(end.x[0].z - up.x);
            switch (integrator) {
                case Integrator::leapfrog:
                case Integrator::velocity_verlet:
                    CHECK(error <= 0.15 * dt * dt + exact);
                    CHECK(std::abs(end.x[0].x - across.x) <= 0.15 * dt * dt + exact);
                    break;
                case Integrator::symplectic_euler:
                case Integrator::forward_euler:
                    CHECK(error <= 10.8 * dt);
                    CHECK(error >= 8.0 * dt);  // first order, and it shows
                    break;
                case Integrator::historical:
                    CHECK(error <= 0.95 * dt);
                    break;
            }
        }
    }
}

void a2_apex_and_range(const Machine& machine) {
    const double dt = 1.0 / 960.0;
    Simulation simulation = start(machine, drag_scene(ball({}, {5, 0, 10}), Integrator::leapfrog, dt));
    dvec3 before(0.0);
    double apex = 0.0;
    double apex_time = 0.0;
    for (int i = 1; i <= 2000; ++i) {
        simulation.substep();
        const dvec3 now = positions_of(simulation)[0];
        if (now.z > apex) {
            apex = now.z;
            apex_time = i * dt;
        }
        if (now.z < 0.0) {
            const double part = before.z / (before.z - now.z);
            const double error = 0.15 * dt * dt + g * dt * dt / 8.0 + rounding_of_drag(machine, i);
            CHECK(std::abs((i - 1 + part) * dt - 1.975795801) <= error / 9.0);  // falling at 9.4 m/s
            CHECK(std::abs(before.x + part * (now.x - before.x) - 8.964258729) <= error);
            CHECK(std::abs(apex - 4.779526515) <= error);
            CHECK(std::abs(apex_time - 0.9716374845) <= machine.tolerance(0.51, 1.5) * dt);
            return;
        }
        before = now;
    }
    FAIL("the ball did not come down");
}

void a3_terminal_velocity(const Machine& machine) {
    struct Row {
        double time, v;
    };
    for (const Row& row : {Row{1.0, -9.325933032}, Row{10.0, -61.94781477}, Row{100.0, -97.99555081}}) {
        REQUIRE(with_drag(0.0, -g, row.time).v == Approx(row.v).epsilon(1e-9));
        const Motion end = motion_after(machine, drag_scene(ball({}, {}), Integrator::leapfrog, 1.0 / 60.0), row.time);
        CAPTURE(row.time);
        CHECK(end.v[0].z == Approx(with_drag(0.0, -g, row.time).v).epsilon(machine.tolerance(1e-12, 1e-5)));
    }
    const double dt = 1.0 / 240.0;
    const Motion fallen = motion_after(machine, drag_scene(ball({}, {}), Integrator::leapfrog, dt), 10.0);
    const Throw discrete = discrete_with_drag(Integrator::leapfrog, 0.0, -g, dt, 2400);
    CHECK(fallen.x[0].z == Approx(discrete.x).epsilon(machine.tolerance(1e-12, 2e-5)));
    CHECK(with_drag(0.0, -g, 10.0).x == Approx(-360.5218523).epsilon(1e-9));
    CHECK(fallen.x[0].z == Approx(-360.5218523).epsilon(1e-6 + machine.tolerance(0.0, 2e-5)));
}

}  // namespace ballpit::test
