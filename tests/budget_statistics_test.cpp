// Whether a chosen count of substeps keeps its promise, asked of the reference in double and of tests' own formulas
// (docs/accuracy.md): the choice meets the budget, the next cheaper count does not, and the scene holds together.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/contact.h"
#include "core/world.h"
#include "cpu/cpu_backend.h"
#include "measure/energy.h"
#include "measure/error_budget.h"
#include "measure/statistics.h"
#include "support/analytic_scene.h"
#include "support/catch.h"
#include "support/oracle.h"
#include "support/scenes.h"

using namespace ballpit;
using measure::BudgetChoice;
using measure::BudgetPreset;
using measure::BudgetQuestion;
using std::numbers::pi;

namespace {

test::Machine reference() {
    return {[] { return std::make_unique<cpu::CpuBackend<double>>(); }, 0.0};
}

// What collisions of one kind leave, over 64 phases.
struct Alone {
    std::vector<double> restitutions;
    std::vector<double> overlaps;  // m
};

// Errors of a count: of 95 % of the phases of the worst kind of collision.
struct Errors {
    double restitution = 0.0;
    double overlap = 0.0;  // diameters
    double gain = 0.0;     // mean share of the energy of a collision
};

Settings of_substep(Settings settings, std::uint32_t substeps, Integrator integrator) {
    settings.dt /= substeps;
    settings.substeps = 1;
    settings.integrator = integrator;
    const bool walls = settings.laws.walls;
    const bool restitution = settings.laws.restitution;
    settings.laws = {};
    settings.laws.walls = walls;
    settings.laws.restitution = restitution;
    return settings;
}

Alone pairs(const BudgetQuestion& question, Settings settings, double speed, int substeps) {
    const measure::ProbeScene& scene = question.probe.scene;
    settings.laws.walls = false;
    const auto left = test::ball({}, {0.5 * speed, 0, 0}, scene.radius, scene.mass);
    const auto right = test::ball({}, {-0.5 * speed, 0, 0}, scene.radius, scene.mass);
    Alone alone;
    for (const auto& c : test::collide(reference(), settings, test::at_64_phases(left, right), substeps)) {
        alone.restitutions.push_back(c.restitution);
        alone.overlaps.push_back(c.max_overlap);
    }
    return alone;
}

Alone walls(const BudgetQuestion& question, const Settings& settings, double speed, int substeps) {
    const measure::ProbeScene& of = question.probe.scene;
    std::vector<BallSpec> balls;
    for (int i = 0; i < 64; ++i) {
        const double gap = speed * settings.dt * (3.0 + (i + 0.5) / 64.0);
        const dvec3 place = test::bench(static_cast<std::size_t>(i), 3.0 * of.radius);
        balls.push_back(test::ball(place + dvec3(of.radius + gap - 4.0, 0, 0), {-speed, 0, 0}, of.radius, of.mass));
    }
    Scene scene = test::wall_scene(balls, settings.integrator, settings.dt);
    scene.half_extent = dvec3(4.0, 100.0, 100.0);
    const std::uint32_t count = scene.settings.balls;
    scene.settings = settings;
    scene.settings.balls = count;
    Simulation simulation = test::start(reference(), scene);
    Alone alone;
    alone.overlaps.assign(64, 0.0);
    for (int step = 0; step < substeps; ++step) {
        simulation.substep();
        const std::vector<dvec3> x = test::positions_of(simulation);
        for (std::size_t i = 0; i < 64; ++i) {
            alone.overlaps[i] = std::max(alone.overlaps[i], test::stored(of.radius) - (x[i].x + 4.0));
        }
    }
    for (const dvec3& v : test::motion_of(simulation).v) {
        alone.restitutions.push_back(v.x / speed);
    }
    return alone;
}

// The largest overlap by steps too small to matter.
double exact_overlap(const test::SpringContact& contact, double speed) {
    test::DiscreteLine line{0.0, -speed, 0.0};
    const double dt = 1e-5 / contact.frequency();
    double deepest = 0.0;
    while (line.v < 0.0) {
        line.step(Integrator::leapfrog, dt, 0.0, contact);
        deepest = std::max(deepest, -line.x);
    }
    return deepest;
}

void add_errors(Errors& errors, const Alone& alone, double e, double overlap, double diameter, bool typical) {
    std::vector<double> of_restitution;
    std::vector<double> of_overlap;
    double gain = 0.0;
    for (std::size_t i = 0; i < alone.restitutions.size(); ++i) {
        of_restitution.push_back(std::abs(alone.restitutions[i] - e));
        of_overlap.push_back(std::abs(alone.overlaps[i] - overlap) / diameter);
        gain += (alone.restitutions[i] * alone.restitutions[i] - e * e) / 64.0;
    }
    errors.restitution = std::max(errors.restitution, measure::quantile(of_restitution, 0.95));
    errors.overlap = std::max(errors.overlap, measure::quantile(of_overlap, 0.95));
    errors.gain = std::max(errors.gain, typical ? std::abs(gain) : 0.0);
}

Errors errors_of(const BudgetQuestion& question, std::uint32_t substeps, Integrator integrator) {
    const measure::ProbeScene& scene = question.probe.scene;
    const Settings settings = of_substep(question.probe.settings, substeps, integrator);
    const double e = scene.restitution;
    const double zeta = damping_ratio_from_restitution(e, settings.limit_force);
    Errors errors;
    for (const bool wall : {false, true}) {
        const double mass = wall ? scene.mass : 0.5 * scene.mass;
        const test::SpringContact contact{settings.stiffness, mass, zeta, settings.limit_force};
        const double duration = pi / contact.frequency();
        const int run = static_cast<int>(std::ceil(1.5 * duration / settings.dt)) + 12;
        for (const double speed : {scene.typical_speed, scene.largest_speed}) {
            const double overlap = exact_overlap(contact, speed);
            if (!wall && overlap > 0.9 * 2.0 * scene.radius) {
                continue;  // they pass through each other
            }
            const Alone alone = wall ? walls(question, settings, speed, run) : pairs(question, settings, speed, run);
            add_errors(errors, alone, e, overlap, 2.0 * scene.radius, speed == scene.typical_speed);
        }
    }
    return errors;
}

// Before the first contact the network is taken for a close packing: W^2 = 8 k / m, and with the pair's dashpot
// Z = 2 zeta.
bool formulas_allow(const BudgetQuestion& question, std::uint32_t substeps) {
    const measure::ProbeScene& scene = question.probe.scene;
    const Settings& settings = question.probe.settings;
    const double dt = settings.dt / substeps;
    const double zeta = damping_ratio_from_restitution(scene.restitution, settings.limit_force);
    const double fastest = std::sqrt(8.0 * settings.stiffness / scene.mass);
    const double pair = std::sqrt(2.0 * settings.stiffness / scene.mass);
    return dt <= 0.9 * 2.0 / fastest * (std::sqrt(1.0 + 4.0 * zeta * zeta) - 2.0 * zeta) && pi / (pair * dt) >= 6.0 &&
           scene.largest_speed * dt <= 0.25 * 2.0 * scene.radius;
}

struct Run {
    double largest_speed = 0.0;
    double energy_before = 0.0;
    double energy_after = 0.0;
    double speed_at_end = 0.0;  // root mean square
};

Run run_scene(const Scene& scene, const BudgetQuestion& question, const BudgetChoice& choice, double seconds) {
    Settings settings = question.probe.settings;
    settings.substeps = choice.substeps;
    settings.integrator = choice.integrator;
    Simulation simulation(scene, settings, test::seed_of(scene), std::make_unique<cpu::CpuBackend<double>>());
    const auto energy = [&](const BallState& state) {
        const measure::Totals t =
            measure::totals_of(state, simulation.settings(), simulation.features(), simulation.box());
        return t.kinetic + t.elastic;
    };
    Run run;
    run.energy_before = energy(simulation.synchronised_state());
    const int steps = test::substeps_in(seconds, settings.dt);
    for (int step = 0; step < steps; ++step) {
        simulation.step();
        double squares = 0.0;
        for (const dvec3& v : test::motion_of(simulation).v) {
            const double square = glm::dot(v, v);
            run.largest_speed = std::max(run.largest_speed, std::isfinite(square) ? std::sqrt(square) : 1e30);
            squares += square;
        }
        run.speed_at_end = std::sqrt(squares / settings.balls);
    }
    run.energy_after = energy(simulation.synchronised_state());
    return run;
}

bool meets(const Errors& errors, double energy, const measure::ErrorBudget& budget) {
    // The probe's 64 phases are of floats, these of doubles: a phase may change places with its neighbour.
    constexpr double slack = 1.05;
    return errors.restitution <= slack * budget.restitution && errors.overlap <= slack * budget.overlap &&
           energy <= slack * budget.energy;
}

// What is lost anyway is the measure where there is a dashpot: collisions take it within a fraction of a second.
double energy_error(const BudgetQuestion& question, const Errors& errors, double seconds_of_run, const Run* run) {
    const double e = question.probe.scene.restitution;
    if (e < 1.0) {
        return errors.gain / (1.0 - e * e);
    }
    return run == nullptr ? 0.0 : std::abs(run->energy_after / run->energy_before - 1.0) / seconds_of_run;
}

}  // namespace

TEST_CASE("a budget's choice keeps its promise in double, and the next cheaper count does not", "[budget]") {
    constexpr std::uint32_t balls = 300;
    constexpr double seconds = 2.0;
    std::printf(
        "| scene | preset | substeps | restitution off | overlap off, diameters | energy | meets | next cheaper |\n");
    for (const char* name : {"pile", "elastic_gas", "rain"}) {
        Scene scene = test::shipped_scene(name);
        scene.settings.balls = balls;
        const World world = make_world(scene, balls, test::seed_of(scene));
        const auto probe = measure::probe_scene(world.balls, scene.settings, world.box, variety_of(world.balls));
        for (const auto preset : {BudgetPreset::fast, BudgetPreset::balanced, BudgetPreset::accurate}) {
            const BudgetQuestion question = measure::budget_question({scene.settings, probe}, preset);
            cpu::CpuBackend<float> mirror;
            const BudgetChoice choice = measure::choose_substeps(mirror, question);
            CAPTURE(name, static_cast<int>(preset), choice.sentence);
            REQUIRE(choice.met);
            const Run run = run_scene(scene, question, choice, seconds);
            const Errors errors = errors_of(question, choice.substeps, choice.integrator);
            const double energy = energy_error(question, errors, seconds, &run);
            CHECK(formulas_allow(question, choice.substeps));
            CHECK(meets(errors, energy, question.budget));
            CHECK(run.largest_speed <= 1.1 * probe.largest_speed * (probe.restitution < 1.0 ? 1.0 : 1.5));
            if (std::string_view(name) == "pile") {
                CHECK(run.speed_at_end < 0.1 * probe.typical_speed);  // it has settled
            }
            const auto place = std::ranges::find(choice.tried, choice.substeps, &measure::Rung::substeps);
            REQUIRE(place != choice.tried.begin());
            const std::uint32_t fewer = (place - 1)->substeps;
            bool fewer_meets = formulas_allow(question, fewer);
            for (const std::uint32_t count : {fewer, 2 * fewer}) {
                const Errors cheaper = errors_of(question, count, choice.integrator);
                fewer_meets &= meets(cheaper, energy_error(question, cheaper, seconds, nullptr), question.budget);
            }
            CHECK_FALSE(fewer_meets);
            std::printf("| %s | %s | %u | %.3g %% | %.3g %% | %.3g %% | %s | %u: %s |\n", name,
                        measure::budget_preset_names[static_cast<std::size_t>(preset)].data(), choice.substeps,
                        100.0 * errors.restitution, 100.0 * errors.overlap, 100.0 * energy,
                        meets(errors, energy, question.budget) ? "yes" : "no", fewer,
                        fewer_meets ? "meets" : "does not");
            std::fflush(stdout);
        }
    }
}
