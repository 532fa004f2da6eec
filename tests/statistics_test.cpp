// A18 to A24: what many balls do on average. Minutes, so not in CTest: `./run statistics`. On the mirror, which the
// GPU agrees with (docs/accuracy.md). Each line printed is a row of the table there.
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/random.h"
#include "cpu/cpu_backend.h"
#include "support/analytic_scene.h"
#include "support/catch.h"
#include "support/gas.h"
#include "support/oracle.h"
#include "support/piles.h"

using namespace ballpit;
using std::numbers::pi;

namespace {

test::Machine mirror() {
    return {[] { return std::make_unique<cpu::CpuBackend<float>>(); }, 1.0};
}

// Prints a row and holds the value to it.
void hold(const char* what, double value, double expected, double tolerance) {
    std::printf("| %s | %.5g | %.5g | %.2g |\n", what, value, expected, tolerance);
    std::fflush(stdout);
    CHECK(value == Approx(expected).margin(tolerance));
}

void run_for(Simulation& simulation, double seconds) {
    test::run(simulation, test::substeps_in(seconds, simulation.settings().dt));
}

// Substeps of a twelfth of a contact.
double substep_of(double stiffness, double reduced_mass) { return pi / std::sqrt(stiffness / reduced_mass) / 12.0; }

Scene gas_of(double share, double stiffness, std::uint32_t count) {
    Scene scene = test::gas_scene(Integrator::leapfrog, substep_of(stiffness, 0.5), count);
    const double narrower = std::cbrt(0.1 / share);
    scene.half_extent *= narrower;
    scene.fill->region = {-scene.half_extent, scene.half_extent};
    scene.settings.stiffness = stiffness;
    return scene;
}

struct GasMeans {
    double kinetic = 0.0, pair_virial = 0.0, wall_virial = 0.0, wall_force = 0.0, density = 0.0;
    std::vector<double> speeds;
};

// 2 s to forget the start, then 20 s: sums every 20 substeps, speeds five times a second.
GasMeans gas_means(Simulation& simulation) {
    run_for(simulation, 2.0);
    GasMeans means;
    const double core = 0.5 * simulation.half_extent().x;
    const int samples = test::substeps_in(20.0, simulation.settings().dt) / 20;
    for (int i = 0; i < samples; ++i) {
        test::run(simulation, 20);
        const test::GasSums sums = test::gas_sums(simulation, true);
        means.kinetic += sums.kinetic / samples;
        means.pair_virial += sums.pair_virial / samples;
        means.wall_virial += sums.wall_virial / samples;
        means.wall_force += sums.wall_force / samples;
        means.density += test::balls_within(simulation, core) / (8.0 * core * core * core) / samples;
        if (i % (samples / 100) == 0) {
            const std::vector<double> now = test::speeds(simulation);
            means.speeds.insert(means.speeds.end(), now.begin(), now.end());
        }
    }
    return means;
}

double mean_power(const std::vector<double>& values, int power) {
    double sum = 0.0;
    for (const double value : values) {
        sum += std::pow(value, power) / static_cast<double>(values.size());
    }
    return sum;
}

}  // namespace

TEST_CASE("A18, A19, A20 virial theorem, Maxwell's speeds, pressure", "[statistics]") {
    for (const double share : {0.05, 0.1}) {
        constexpr double stiffness = 1e6;
        constexpr int count = 1000;
        Simulation simulation = test::start(mirror(), gas_of(share, stiffness, count));
        const GasMeans means = gas_means(simulation);
        CAPTURE(share);
        std::printf("volume share %.2g:\n", share);
        // With the velocities of half substeps the virial theorem holds for leapfrog without a truncation error.
        hold("A18 virial", (2.0 * means.kinetic + means.pair_virial) / means.wall_virial, 1.0, 3e-3);
        const double square = mean_power(means.speeds, 2);
        hold("A19 mean speed^2 / mean square", std::pow(mean_power(means.speeds, 1), 2) / square, 8.0 / (3.0 * pi),
             0.004);
        hold("A19 mean 4th power / mean square^2", mean_power(means.speeds, 4) / (square * square), 5.0 / 3.0, 0.03);
        hold("A19 chi^2 per degree of freedom, 40 bins", test::maxwell_chi_squared(means.speeds, 40), 1.0, 1.0);
        // Carnahan and Starling with the diameter that soft balls have on average (Barker and Henderson).
        const double heat = 2.0 * means.kinetic / (3.0 * count);
        const double free_side = 2.0 * (simulation.half_extent().x - test::gas_radius);
        const double diameter = 2.0 * test::gas_radius - std::sqrt(pi * heat / (2.0 * stiffness));
        const double f = pi / 6.0 * means.density * diameter * diameter * diameter;
        const double expected = means.density * heat * (1.0 + f + f * f - f * f * f) / std::pow(1.0 - f, 3);
        hold("A20 pressure / expected", means.wall_force / (6.0 * free_side * free_side) / expected, 1.0, 0.03);
    }
}

TEST_CASE("A21 equipartition", "[statistics]") {
    // 500 heavy balls at rest between 500 light ones at 3 m/s, on alternating places of a lattice.
    constexpr double side = 2.3;
    std::vector<BallSpec> balls;
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const uvec3 cell(i % 10, i / 10 % 10, i / 100);
        const dvec3 place = 0.1 * dvec3(cell) - 0.45;
        const bool heavy = (cell.x + cell.y + cell.z) % 2 == 0;
        const double z = 2.0 * random_unit(1, 0, i) - 1.0;
        const double angle = 2.0 * pi * random_unit(1, 1, i);
        const dvec3 direction(std::sqrt(1.0 - z * z) * std::cos(angle), std::sqrt(1.0 - z * z) * std::sin(angle), z);
        balls.push_back(heavy ? test::ball(side * place, {}, 0.08, 8.0)
                              : test::ball(side * place, 3.0 * direction, 0.04, 1.0));
    }
    Scene scene = test::wall_scene(balls, Integrator::leapfrog, substep_of(1e5, 0.5));
    scene.half_extent = dvec3(0.5 * side);
    scene.settings.stiffness = 1e5;
    scene.settings.laws.contact = true;
    Simulation simulation = test::start(mirror(), scene);
    run_for(simulation, 8.0);
    double heavy = 0.0;
    double light = 0.0;
    for (int sample = 0; sample < 240; ++sample) {
        run_for(simulation, 0.05);
        for (const vec4& v : simulation.raw_state().velocities) {
            (v.w > 4.0f ? heavy : light) += static_cast<double>(v.w) * glm::dot(dvec3(v), dvec3(v));
        }
    }
    hold("A21 kinetic energy, heavy / light", heavy / light, 1.0, 0.03);
}

TEST_CASE("A22 barometric law", "[statistics]") {
    constexpr double radius = 0.02;
    constexpr int count = 500;
    Scene scene = test::gas_scene(Integrator::leapfrog, substep_of(1e5, 0.5), count);
    scene.half_extent = dvec3(1.0);
    scene.fill->radius = {radius, radius};
    scene.fill->density = 1.0 / (4.0 / 3.0 * pi * radius * radius * radius);
    scene.fill->speed = 4.0;
    scene.fill->region = {dvec3(-1.0), dvec3(1.0)};
    scene.settings.laws.gravity = true;
    Simulation simulation = test::start(mirror(), scene);
    run_for(simulation, 30.0);
    double kinetic = 0.0;
    double height = 0.0;
    constexpr int samples = 600;
    for (int sample = 0; sample < samples; ++sample) {
        run_for(simulation, 0.05);
        kinetic += test::gas_sums(simulation, false).kinetic / samples;
        height += mean_power(test::heights(simulation), 1) / samples;
    }
    const double scale = 2.0 * kinetic / (3.0 * count) / 9.8;
    const double room = 2.0 - 2.0 * radius;
    const double expected = radius + scale - room / (std::exp(room / scale) - 1.0);
    hold("A22 mean height / expected", height / expected, 1.0, 0.05);
}

TEST_CASE("A23 Haff's law", "[statistics]") {
    // The program's walls are as lossy as its balls: their share is added to the rate.
    constexpr double e = 0.9;
    constexpr int count = 1000;
    Scene scene = gas_of(0.05, 1e5, count);
    Simulation simulation = test::start(mirror(), scene);
    run_for(simulation, 2.0);
    Settings lossy = simulation.settings();
    lossy.laws.restitution = true;
    lossy.restitution = e;
    simulation.change(lossy);
    const auto temperature = [&] { return 2.0 * test::gas_sums(simulation, false).kinetic / (3.0 * count); };
    const double begin = temperature();
    const double diameter = 2.0 * test::gas_radius;
    const double side = 2.0 * simulation.half_extent().x;
    const double density = count / (side * side * side);
    const double f = pi / 6.0 * density * diameter * diameter * diameter;
    const double chi = (1.0 - 0.5 * f) / std::pow(1.0 - f, 3);
    const double collisions = 4.0 * density * diameter * diameter * chi * std::sqrt(pi * begin);
    const double walls = 6.0 / (side - diameter) * std::sqrt(begin / (2.0 * pi)) / 3.0;
    const double rate = (1.0 - e * e) * (collisions / 6.0 + walls);
    double worst = 0.0;
    for (int second = 1; second <= 8; ++second) {
        run_for(simulation, 1.0);
        const double found = (std::sqrt(begin / temperature()) - 1.0) / second;
        worst = std::max(worst, std::abs(found / rate - 1.0));
        if (second == 8) {
            hold("A23 rate of cooling over 8 s / expected", found / rate, 1.0, 0.1);
        }
    }
    hold("A23 worst second of those", worst, 0.0, 0.1);
}

TEST_CASE("A24 a pile weighs on the floor what it weighs", "[statistics]") {
    constexpr int count = 500;
    Scene scene = test::gas_scene(Integrator::leapfrog, substep_of(1e4, 0.5), count);
    constexpr double radius = 0.05;
    scene.half_extent = dvec3(0.5, 0.5, 1.0);
    scene.fill->radius = {radius, radius};
    scene.fill->density = 1.0 / (4.0 / 3.0 * pi * radius * radius * radius);
    scene.fill->speed = 0.5;
    scene.fill->region = {dvec3(-0.5, -0.5, -1.0), dvec3(0.5, 0.5, 1.0)};
    scene.settings.stiffness = 1e4;
    scene.settings.laws.gravity = scene.settings.laws.restitution = true;
    scene.settings.restitution = 0.5;
    Simulation simulation = test::start(mirror(), scene);
    run_for(simulation, 10.0);
    double force = 0.0;
    constexpr int samples = 400;
    for (int sample = 0; sample < samples; ++sample) {
        test::run(simulation, 5);
        force += test::gas_sums(simulation, true).floor_force / samples;
    }
    hold("A24 force on the floor / weight", force / (count * 9.8), 1.0, 1e-3);
}

// Piles at rest: what moves is rounding, which feeds every spring the same however long a substep is. So a pile is held
// to what the very same pile does at a quarter of the gauge's dt_c: an unstable mode grows by 2 acosh(dt / dt_c) a
// substep, 1e5 times and more in a hundred; below the limit it cannot.
TEST_CASE("piles at rest stay so below the red line of dt / dt_c, and grow above", "[statistics][stability]") {
    constexpr std::array marks{300, 10000};
    std::puts(
        "| pile at rest | true dt_c, ms | of the gauge | largest K / m g r of 10 000 substeps at 1/4, 9/10 of the "
        "gauge's | of 300 at 1.1 of the true one, at 1/4 |");
    for (const bool unequal : {false, true}) {
        const test::SettledPile settled = test::settled_pile(unequal, 300);
        for (const double restitution : {1.0, 0.9, 0.5, 0.2}) {
            const test::SettledPile pile = test::with_restitution(settled, restitution);
            const double critical = test::true_critical_dt(pile);
            const double gauge = test::gauge_critical_dt(pile);
            const auto quiet = test::course_of(pile, 0.25 * gauge, marks);
            const double below = test::agitation(pile, 0.9 * gauge, marks.back());
            const double above = test::agitation(pile, 1.1 * critical, marks.front());
            std::printf("| %s, e = %g | %.3f | %.3f | %.1e, %.1e | %.1e, %.1e |\n",
                        unequal ? "radii 1:2" : "equal radii", restitution, 1e3 * critical, 1e3 * gauge,
                        quiet.back().agitation, below, above, quiet.front().agitation);
            std::fflush(stdout);
            CHECK(gauge < critical);
            CHECK(below < 10.0 * quiet.back().agitation);
            CHECK(above > 100.0 * quiet.front().agitation);
        }
    }
}

// What dt_c cannot tell: contacts that open and close err by up to 1.23 / n^2 each (docs/accuracy.md), and without a
// loss those errors compound. The gauge of substeps a contact is for that.
TEST_CASE("piles that move without loss heat where a contact has few substeps", "[statistics][stability]") {
    constexpr double kick = 0.01;
    constexpr std::array marks{1000, 10000};
    std::puts("| pile that moves, e = 1 | substeps a contact | dt / dt_c | energy gained / m g r in 1000, 10 000 |");
    for (const bool unequal : {false, true}) {
        const test::SettledPile pile = test::kicked(test::settled_pile(unequal, 300), kick);
        const double critical = test::gauge_critical_dt(pile);
        const double contact = test::shortest_contact(pile);
        const auto gain = [&](double dt) {
            const auto course = test::course_of(pile, dt, marks);
            std::printf("| %s | %.1f | %.2f | %.2g, %.2g |\n", unequal ? "radii 1:2" : "equal radii", contact / dt,
                        dt / critical, course[0].gain, course[1].gain);
            std::fflush(stdout);
            return std::abs(course[1].gain);
        };
        CHECK(gain(contact / 20.0) < 0.01 * kick);
        CHECK(gain(contact / 10.0) < 0.1 * kick);
        gain(contact / 6.0);
        gain(contact / 4.0);
        gain(0.9 * critical);
    }
}
