// A15: two balls meet off their line of centres; there is no force along the surface, so they turn each other.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "support/analytic_scene.h"
#include "support/catch.h"
#include "support/oracle.h"

namespace ballpit::test {

namespace {

using std::numbers::pi;

constexpr double degree = pi / 180.0;
constexpr double reach = 0.2;

double cross_z(const dvec3& a, const dvec3& b) { return a.x * b.y - a.y * b.x; }

// The relative motion, substep by substep: spring and dashpot push along the line of centres, and never pull.
dvec3 discrete_velocity(const Collision& c, const Settings& settings, double damping_ratio, int steps) {
    const double mass = c.left.mass * c.right.mass / (c.left.mass + c.right.mass);
    const double damping = 2.0 * damping_ratio * std::sqrt(settings.stiffness * mass);
    const double radii = c.left.radius + c.right.radius;
    const dvec3 offset = c.right.position - c.left.position;
    const dvec3 velocity = c.right.velocity - c.left.velocity;
    DiscreteLine x{offset.x, velocity.x, 0.0};
    DiscreteLine y{offset.y, velocity.y, 0.0};
    for (int i = 0; i < steps; ++i) {
        const double distance = std::hypot(x.x, y.x);
        const double parting = (x.x * x.v + y.x * y.v) / distance;
        const double force = settings.stiffness * (radii - distance) - damping * parting;
        const double rate = distance < radii ? std::max(force, 0.0) / (mass * distance) : 0.0;
        const dvec3 a(rate * x.x, rate * y.x, 0.0);
        x.step(settings.integrator, settings.dt, 0.0, [&](double, double) { return a.x; });
        y.step(settings.integrator, settings.dt, 0.0, [&](double, double) { return a.y; });
    }
    return {x.v, y.v, 0.0};  // far apart, where a velocity that lags is the same
}

// Angular momentum of the relative motion over the reduced mass.
double turning(const Collision& c) { return cross_z(c.x[1] - c.x[0], c.v[1] - c.v[0]); }
double turning_before(const Collision& c) {
    return cross_z(c.right.position - c.left.position, c.right.velocity - c.left.velocity);
}

constexpr std::array impact_parameters = {.05, .1, .15, .19};
constexpr std::size_t phases = 16;

std::vector<Encounter> glancing_encounters() {
    std::vector<Encounter> encounters;
    for (const double b : impact_parameters) {
        for (std::size_t phase = 0; phase < phases; ++phase) {
            encounters.push_back({ball({}, {1, 0, 0}), ball({}, {-1, 0, 0}), b,
                                  (static_cast<double>(phase) + 0.5) / static_cast<double>(phases)});
        }
    }
    return encounters;
}

void check_scattering(const Machine& machine, Integrator integrator, double stiffness, int n) {
    const double dt = pi / std::sqrt(2.0 * stiffness) / n;
    Settings settings = scene_of({}, integrator, dt).settings;
    settings.stiffness = stiffness;
    // The smaller the overlap, the larger the share of it that an ulp of a position is.
    const double rounding = machine.rounding * 6e-5 * std::sqrt(stiffness / canonical_stiffness);
    const int steps = 2 * n + 8;
    const std::vector<Collision> collisions = collide(machine, settings, glancing_encounters(), steps);
    std::array<double, impact_parameters.size()> worst{};
    for (std::size_t i = 0; i < collisions.size(); ++i) {
        const Collision& c = collisions[i];
        const double b = impact_parameters[i / phases];
        const Scattering exact = scattering(stiffness, reach, b);
        const dvec3 relative = c.v[1] - c.v[0];
        const double error = std::abs(std::atan2(relative.y, -relative.x) - exact.angle) / degree;
        worst[i / phases] = std::max(worst[i / phases], error);
        CAPTURE(integrator_names[static_cast<std::size_t>(integrator)], stiffness, b, n, error);
        CHECK(glm::length(relative - discrete_velocity(c, settings, 0.0, steps)) <= 1e-11 + 6.0 * rounding);
        CHECK(std::abs(c.v[0].y + c.v[1].y) <= machine.tolerance(1e-13, 4 * 1.2e-7));
        if (integrator != Integrator::historical) {
            // An oblique contact lasts no whole number of substeps: h^2 / 8 as in A4 between whole numbers.
            CHECK(std::abs(glm::length(relative) / 2.0 - 1.0) <= 1.3 / (n * n) + rounding);
            CHECK(std::abs(turning(c) - turning_before(c)) <= 1e-13 + rounding);
            CHECK(c.max_overlap == Approx(exact.max_overlap).epsilon(1.24 / (n * n) + 10.0 * rounding));
            CHECK(std::abs(c.duration - exact.duration) <= 1.01 * dt);
        }
    }
    for (std::size_t i = 0; i < worst.size(); ++i) {
        CAPTURE(integrator_names[static_cast<std::size_t>(integrator)], stiffness, impact_parameters[i], n);
        if (integrator == Integrator::historical) {
            CHECK(worst[i] <= (impact_parameters[i] == 0.1 ? 64.0 : 70.0) / n);  // 64 is the figure of b = 0.1
        } else {
            CHECK(worst[i] <= 40.0 / (n * n) + rounding / degree);
        }
    }
}

}  // namespace

void a15_oblique_with_dashpot(const Machine& machine) {
    constexpr double zeta = 0.2;
    constexpr int n = 32;
    constexpr int steps = 3 * n;
    const double mass = 8.0 / 9.0;
    for (const Integrator integrator : symplectic) {
        Settings settings = scene_of({}, integrator, pi / std::sqrt(canonical_stiffness / mass) / n).settings;
        settings.laws.restitution = true;
        settings.restitution = exact_restitution(zeta, true);
        for (const double b : {0.0, 0.15}) {
            const auto encounters = at_64_phases(ball({}, {1, 0, 0}), ball({}, {-1, 0, 0}, 0.2, 8.0), b);
            for (const Collision& c : collide(machine, settings, encounters, steps)) {
                const dvec3 relative = c.v[1] - c.v[0];
                CAPTURE(integrator_names[static_cast<std::size_t>(integrator)], b);
                CHECK(glm::length(relative - discrete_velocity(c, settings, zeta, steps)) <=
                      machine.tolerance(1e-9, 1e-4));
                CHECK(std::abs(turning(c) - turning_before(c)) <= machine.tolerance(1e-12, 3e-5));
                CHECK(std::abs(c.v[0].x + 8.0 * c.v[1].x + 7.0) <= machine.tolerance(1e-12, 1e-5));
                CHECK(std::abs(c.v[0].y + 8.0 * c.v[1].y) <= machine.tolerance(1e-12, 1e-5));
                if (b == 0.0) {
                    CHECK(std::abs(c.restitution - settings.restitution) <=
                          1.2 * 2.0 * pi * zeta * settings.restitution / n + machine.rounding * 3e-5);
                }
            }
        }
    }
}

void a15_oblique_scattering(const Machine& machine) {
    REQUIRE(scattering(1e4, reach, .05).angle / degree == Approx(147.574881).epsilon(1e-8));
    REQUIRE(scattering(1e4, reach, .19).angle / degree == Approx(25.665258).epsilon(1e-7));
    REQUIRE(scattering(1e5, reach, .1).angle / degree == Approx(117.945958).epsilon(1e-8));
    REQUIRE(scattering(1e6, reach, .15).angle / degree == Approx(81.862683).epsilon(1e-7));
    REQUIRE(scattering(1e4, reach, .1).max_overlap == Approx(0.011976129).epsilon(1e-7));
    REQUIRE(scattering(1e4, reach, .1).duration == Approx(0.021880837).epsilon(1e-7));
    for (const int n : {20, 50}) {
        for (const Integrator integrator : symplectic) {
            check_scattering(machine, integrator, 1e4, n);
        }
        check_scattering(machine, Integrator::historical, 1e4, n);
        check_scattering(machine, Integrator::leapfrog, 1e5, n);
        check_scattering(machine, Integrator::leapfrog, 1e6, n);
    }
}

}  // namespace ballpit::test
