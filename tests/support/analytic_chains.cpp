// A10, A13 and A14: rows of balls in which several contacts work at once.
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

constexpr double g = 9.8;
constexpr double sag = g / canonical_stiffness;  // m: overlap that carries one ball

std::string_view name_of(Integrator integrator) { return integrator_names[static_cast<std::size_t>(integrator)]; }

// Ten balls on the floor, one over the other, with `share` of the overlaps that carry them, and another `nudge` (m)
// of the second highest.
Scene column_scene(Integrator integrator, double dt, double share, double nudge) {
    constexpr double depth = 2.0;
    std::vector<BallSpec> balls;
    double top = -depth;
    for (int i = 0; i < 10; ++i) {
        top -= share * sag * (10 - i);
        balls.push_back(ball({0, 0, top + 0.1 + (i == 8 ? nudge : 0.0)}, {}));
        top += 0.2;
    }
    Scene scene = scene_of(balls, integrator, dt);
    scene.half_extent = {0.5, 0.5, depth};
    scene.settings.laws.gravity = scene.settings.laws.contact = scene.settings.laws.walls = true;
    return scene;
}

double kinetic_energy(const Motion& motion) {
    double sum = 0.0;
    for (const dvec3& v : motion.v) {
        sum += 0.5 * glm::dot(v, v);
    }
    return sum;
}

constexpr double chain_overlap = 0.03125;
constexpr double chain_spacing = 0.25 - chain_overlap;

}  // namespace

Scene chain_scene(Integrator integrator, double dt, double kick) {
    std::vector<BallSpec> balls;
    balls.reserve(101);
    for (int i = 0; i < 101; ++i) {
        balls.push_back(ball({chain_spacing * (i - 50), 0, 0}, {i == 50 ? kick : 0.0, 0, 0}, 0.125));
    }
    Scene scene = scene_of(balls, integrator, dt);
    scene.half_extent = {chain_spacing * 50 + 0.125 - chain_overlap, 0.25, 0.25};
    scene.settings.laws.contact = scene.settings.laws.walls = true;
    return scene;
}

void a10_column_at_rest(const Machine& machine) {
    Scene scene = column_scene(Integrator::leapfrog, 0.002, 0.9, 0.0);
    scene.settings.laws.restitution = true;
    scene.settings.restitution = exact_restitution(0.8, true);
    const Motion end = motion_after(machine, scene, 8.0);
    double below = -2.0;
    for (std::size_t i = 0; i < 10; ++i) {
        const double reach = i == 0 ? 0.1 : 0.2;
        const double overlap = reach - (end.x[i].z - below);
        CAPTURE(i, overlap);
        CHECK(overlap == Approx(sag * static_cast<double>(10 - i)).epsilon(1e-3));
        below = end.x[i].z;
    }
    CHECK(end.x[9].z + 2.0 == Approx(1.8461).margin(1e-6));
    CHECK(kinetic_energy(end) <= 1e-8);
}

void a10_column_at_the_stability_limit(const Machine& machine) {
    const double limit = 2.0 / (2.0 * wall_frequency * std::sin(19.0 * pi / 42.0));
    REQUIRE(limit == Approx(0.01011295333).epsilon(1e-9));
    REQUIRE(2.0 * wall_frequency * std::sin(pi / 42.0) == Approx(14.94601872).epsilon(1e-9));
    for (const Integrator integrator : symplectic) {
        const auto energy_after = [&](double share) {
            // A nudge in units of sag / 1000 keeps every contact closed, as long as the column is stable.
            const Scene scene = column_scene(integrator, share * limit, 1.0, 1e-3 * sag);
            return kinetic_energy(motion_after(machine, scene, 400 * share * limit));
        };
        CAPTURE(name_of(integrator));
        const double stable = energy_after(0.99);
        const double unstable = energy_after(1.01);
        CAPTURE(stable, unstable);
        CHECK(stable <= machine.tolerance(5e-8, 1e-6));  // the nudge holds 1e-8 J
        CHECK(!(unstable <= 1e-2));                      // no number at all is blown up, too
    }
}

void a13_kicked_chain(const Machine& machine) {
    constexpr double kick = 1.0;
    REQUIRE(bessel_j(0, 20.0) == Approx(0.167025).epsilon(1e-5));
    REQUIRE(bessel_j(20, 20.0) == Approx(0.164748).epsilon(1e-5));
    for (const double h : {0.1, 0.025}) {
        const double dt = h / wall_frequency;
        for (const Integrator integrator : {Integrator::leapfrog, Integrator::velocity_verlet}) {
            const Scene scene = chain_scene(integrator, dt, kick);
            const Motion end = motion_after(machine, scene, 10.0 / wall_frequency);
            double worst = 0.0;
            for (std::size_t n = 0; n <= 12; n += 2) {
                const double exact = bessel_j(static_cast<int>(2 * n), 20.0);
                const double right = end.v[50 + n].x / kick;
                const double left = end.v[50 - n].x / kick;
                worst = std::max({worst, std::abs(right - exact), std::abs(left - exact)});
                CHECK(std::abs(right - left) <= machine.tolerance(1e-10, 5e-4));
            }
            CAPTURE(h, name_of(integrator), worst / (h * h));
            CHECK(worst <= 0.43 * h * h + machine.tolerance(0.0, 3e-4));
            CHECK(worst >= 0.3 * h * h - machine.tolerance(0.0, 3e-4));
        }
    }
}

namespace {

constexpr std::array cradle_sizes = {3, 4, 5, 10};

// Rows of touching balls, one beside the other, each struck by its first.
Scene cradle_scene(Integrator integrator, double dt) {
    std::vector<BallSpec> balls;
    for (const int count : cradle_sizes) {
        for (int i = 0; i < count; ++i) {
            balls.push_back(ball({-1.25 + 0.25 * i, 0.5 * count - 2.0, 0}, {i == 0 ? 1.0 : 0.0, 0, 0}, 0.125));
        }
    }
    Scene scene = scene_of(balls, integrator, dt);
    scene.settings.laws.contact = true;
    return scene;
}

double largest_difference(const std::vector<double>& expected, const Motion& motion, std::size_t first) {
    double largest = 0.0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        largest = std::max(largest, std::abs(motion.v[first + i].x - expected[i]));
    }
    return largest;
}

}  // namespace

void a14_newtons_cradle(const Machine& machine) {
    REQUIRE(cradle_velocities(3)[2] == Approx(0.980032126).epsilon(1e-7));
    REQUIRE(cradle_velocities(4)[2] == Approx(0.236977607).epsilon(1e-7));
    REQUIRE(cradle_velocities(5)[0] == Approx(-0.132279485).epsilon(1e-7));
    REQUIRE(cradle_velocities(10)[9] == Approx(0.877671242).epsilon(1e-7));
    for (const int n : {20, 50}) {
        for (const Integrator integrator : {Integrator::leapfrog, Integrator::symplectic_euler,
                                            Integrator::velocity_verlet, Integrator::historical}) {
            if (machine.slow && n == 50) {
                continue;
            }
            const double dt = pi / pair_frequency / n;
            const Motion end = motion_after(machine, cradle_scene(integrator, dt), 24.0 * n * dt);
            std::size_t first = 0;
            for (const int count : cradle_sizes) {
                const double worst = largest_difference(cradle_velocities(count), end, first);
                const double off = largest_difference(discrete_cradle(count, integrator, n), end, first);
                first += static_cast<std::size_t>(count);
                CAPTURE(count, n, name_of(integrator), worst * n, worst * n * n);
                CHECK(off <= machine.tolerance(1e-11, 1e-4));
                if (integrator == Integrator::historical) {
                    // Gains compound: more with fewer substeps, and with more contacts to pass.
                    CHECK(worst <= (count == 10 ? 4.8 : count == 5 ? 3.1 : 2.8) / n);
                    CHECK(worst >= 0.7 / n);
                } else {
                    CHECK(worst <= (count == 10 ? 0.81 : 0.8) / (n * n) + machine.rounding * 3e-5);
                }
            }
        }
    }
}

}  // namespace ballpit::test
