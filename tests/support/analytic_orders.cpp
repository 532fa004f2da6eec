// By how much an error shrinks when the substep is halved, for each quantity and integrator: the slope over three
// halvings, of errors averaged over at least 64 phases.
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

// Least-squares slope of log error over log dt; resolutions are substeps in the same time.
template <class Error>
double order_of(const std::vector<double>& resolutions, const Error& error) {
    double sum_x = 0.0, sum_y = 0.0, sum_xx = 0.0, sum_xy = 0.0;
    for (const double n : resolutions) {
        const double x = -std::log2(n);
        const double y = std::log2(error(n));
        sum_x += x;
        sum_y += y;
        sum_xx += x * x;
        sum_xy += x * y;
    }
    const auto count = static_cast<double>(resolutions.size());
    return (sum_xy - sum_x * sum_y / count) / (sum_xx - sum_x * sum_x / count);
}

template <class Values, class Error>
double mean_size(const Values& values, const Error& error) {
    double sum = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        sum += std::abs(error(i)) / static_cast<double>(values.size());
    }
    return sum;
}

// 64 balls thrown at different speeds, away from each other.
Scene throws(Integrator integrator, double dt, bool drag) {
    std::vector<BallSpec> balls;
    balls.reserve(64);
    for (int i = 0; i < 64; ++i) {
        balls.push_back(ball({}, {0.05 * i, 0, 2.0 + 0.125 * i}));
    }
    Scene scene = scene_of(balls, integrator, dt);
    scene.settings.laws.gravity = true;
    scene.settings.laws.drag = drag;
    scene.settings.drag = 1.0;
    return scene;
}

double throw_error(const Machine& machine, Integrator integrator, double n, bool drag) {
    const Scene scene = throws(integrator, 1.0 / n, drag);
    const Motion end = motion_after(machine, scene, 1.0);
    return mean_size(end.x, [&](std::size_t i) {
        const double v0 = stored(scene.balls[i].velocity.z);
        const double exact = drag ? -g + (v0 + g) * (1.0 - std::exp(-1.0)) : v0 - 0.5 * g;
        return end.x[i].z - exact;
    });
}

double elastic_error(const Machine& machine, Integrator integrator, double n) {
    const Settings settings = scene_of({}, integrator, pi / pair_frequency / n).settings;
    const auto collisions = collide(machine, settings, at_64_phases(ball({}, {1, 0, 0}), ball({}, {-1, 0, 0})),
                                    static_cast<int>(2.0 * n) + 8);
    return mean_size(collisions, [&](std::size_t i) { return collisions[i].restitution - 1.0; });
}

// The contact lasts n / sqrt(1 - zeta^2) substeps: how much of one is left over decides, together with the phase.
double damped_error_at(const Machine& machine, Integrator integrator, double n) {
    constexpr double zeta = 0.1;
    Settings settings = scene_of({}, integrator, pi / pair_frequency / n).settings;
    settings.laws.restitution = true;
    settings.limit_force = false;
    settings.restitution = exact_restitution(zeta, false);
    const auto collisions = collide(machine, settings, at_64_phases(ball({}, {1, 0, 0}), ball({}, {-1, 0, 0})),
                                    static_cast<int>(2.0 * n) + 8);
    return mean_size(collisions, [&](std::size_t i) { return collisions[i].restitution - settings.restitution; });
}

double damped_error(const Machine& machine, Integrator integrator, double n) {
    double sum = 0.0;
    for (const double part : {0.0, 0.25, 0.5, 0.75}) {
        sum += damped_error_at(machine, integrator, n + part) / 4.0;
    }
    return sum;
}

// Where balls let go at 64 heights are after 1 s and one or two bounces.
double bounce_error(const Machine& machine, Integrator integrator, double n) {
    std::vector<BallSpec> balls;
    balls.reserve(64);
    for (int i = 0; i < 64; ++i) {
        balls.push_back(ball({0, 0, 0.001 * (i - 31.5)}, {}));
    }
    const int substeps = substeps_in(n, pi / wall_frequency);
    Scene scene = scene_of(balls, integrator, 1.0 / substeps);
    scene.half_extent = {1.0, 1.0, 1.125};
    scene.settings.laws.gravity = scene.settings.laws.walls = true;
    const Motion end = motion_after(machine, scene, 1.0);
    return mean_size(end.x, [&](std::size_t i) {
        const auto above = [](double z) { return z + 1.125 - stored(0.1); };
        const double height = above(stored(balls[i].position.z));
        return above(end.x[i].z) - bouncing(height, wall_frequency, g, 1.0).first;
    });
}

// n: substeps in w t = 1. Velocities are held against those of `late` substeps before.
double chain_error(const Machine& machine, Integrator integrator, double n, double late = 0.0) {
    constexpr double kick = 1.0;
    const Motion end =
        motion_after(machine, chain_scene(integrator, 1.0 / (n * wall_frequency), kick), 10.0 / wall_frequency);
    return mean_size(end.v, [&](std::size_t i) {
        return end.v[i].x / kick - bessel_j(2 * std::abs(static_cast<int>(i) - 50), 2.0 * (10.0 - late / n));
    });
}

}  // namespace

void order_of_free_flight(const Machine& machine) {
    const std::vector<double> resolutions = {16, 32, 64, 128};
    for (const Integrator integrator :
         {Integrator::leapfrog, Integrator::velocity_verlet, Integrator::historical}) {  // exact: nothing to halve
        CHECK(throw_error(machine, integrator, 16, false) <= machine.tolerance(1e-13, 1e-5));
    }
    CHECK(order_of(resolutions, [&](double n) {
              return throw_error(machine, Integrator::symplectic_euler, n, false);
          }) == Approx(1.0).margin(0.3));
    const auto order_with_drag = [&](Integrator integrator) {
        return order_of(resolutions, [&](double n) { return throw_error(machine, integrator, n, true); });
    };
    CHECK(order_with_drag(Integrator::leapfrog) == Approx(2.0).margin(0.3));
    CHECK(order_with_drag(Integrator::velocity_verlet) == Approx(2.0).margin(0.3));
    CHECK(order_with_drag(Integrator::symplectic_euler) == Approx(1.0).margin(0.3));
    CHECK(order_with_drag(Integrator::historical) == Approx(1.0).margin(0.3));
}

void order_of_elastic_restitution(const Machine& machine) {
    for (const Integrator integrator : symplectic) {
        const auto error = [&](double n) { return elastic_error(machine, integrator, n); };
        CAPTURE(name_of(integrator));
        CHECK(
            order_of(machine.rounding == 0.0 ? std::vector<double>{8, 16, 32, 64} : std::vector<double>{5, 10, 20, 40},
                     error) == Approx(3.0).margin(0.3));
        CHECK(order_of({10.5, 20.5, 40.5, 80.5}, error) == Approx(2.0).margin(0.3));
    }
    CHECK(order_of({16, 32, 64, 128}, [&](double n) { return elastic_error(machine, Integrator::historical, n); }) ==
          Approx(1.0).margin(0.3));
    CHECK(order_of({16, 32, 64, 128}, [&](double n) { return elastic_error(machine, Integrator::forward_euler, n); }) ==
          Approx(1.0).margin(0.3));
}

void order_of_damped_restitution(const Machine& machine) {
    for (const Integrator integrator :
         {Integrator::leapfrog, Integrator::symplectic_euler, Integrator::velocity_verlet, Integrator::historical}) {
        CAPTURE(name_of(integrator));
        CHECK(order_of({16, 32, 64, 128}, [&](double n) { return damped_error(machine, integrator, n); }) ==
              Approx(1.0).margin(0.3));
    }
}

void order_of_bounces(const Machine& machine) {
    const std::vector<double> resolutions = {10, 20, 40, 80};
    const auto order = [&](Integrator integrator) {
        return order_of(resolutions, [&](double n) { return bounce_error(machine, integrator, n); });
    };
    CHECK(order(Integrator::leapfrog) == Approx(2.0).margin(0.3));
    CHECK(order(Integrator::velocity_verlet) == Approx(2.0).margin(0.3));
    CHECK(order(Integrator::historical) == Approx(1.0).margin(0.3));
    const double euler = order(Integrator::symplectic_euler);
    CAPTURE(euler);
    CHECK(euler >= 0.7);
    CHECK(euler <= 2.3);
}

void order_of_chain(const Machine& machine) {
    const std::vector<double> resolutions = {5, 10, 20, 40};
    const auto order = [&](Integrator integrator) {
        return order_of(resolutions, [&](double n) { return chain_error(machine, integrator, n); });
    };
    CHECK(order(Integrator::leapfrog) == Approx(2.0).margin(0.3));
    CHECK(order(Integrator::velocity_verlet) == Approx(2.0).margin(0.3));
    // Nothing pushes at first, so symplectic Euler moves the balls exactly as leapfrog does; but the velocities that it
    // shows are those of half a substep before, which as velocities of the moment are of first order.
    CHECK(order_of(resolutions, [&](double n) { return chain_error(machine, Integrator::symplectic_euler, n, 0.5); }) ==
          Approx(2.0).margin(0.3));
    CHECK(order(Integrator::symplectic_euler) == Approx(1.0).margin(0.3));
    CHECK(order_of({40, 80, 160, 320}, [&](double n) { return chain_error(machine, Integrator::historical, n); }) ==
          Approx(1.0).margin(0.3));
}

}  // namespace ballpit::test
