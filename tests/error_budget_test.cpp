// From a budget to a count of substeps: formulas, the ladder, and what is said of it.
#include "measure/error_budget.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/contact.h"
#include "core/world.h"
#include "cpu/cpu_backend.h"
#include "support/catch.h"
#include "support/piles.h"
#include "support/probe_contract.h"
#include "support/scenes.h"

using namespace ballpit;
using measure::BudgetChoice;
using measure::BudgetPreset;
using measure::BudgetQuestion;
using measure::Demand;
using measure::Rung;

namespace {

BudgetChoice choose(const BudgetQuestion& question) {
    cpu::CpuBackend<float> backend;
    return measure::choose_substeps(backend, question);
}

BudgetQuestion question_of(std::string_view name, std::uint32_t balls, BudgetPreset preset) {
    return measure::budget_question(test::question_of(test::shipped_scene(name), balls), preset);
}

const Rung& rung(const BudgetChoice& choice, std::uint32_t substeps) {
    const auto found = std::ranges::find(choice.tried, substeps, &Rung::substeps);
    REQUIRE(found != choice.tried.end());
    return *found;
}

}  // namespace

TEST_CASE("a choice meets its budget, at twice the count as well, and the next cheaper count does not", "[budget]") {
    for (const auto& [name, balls] : {std::pair{"pile", 400u}, {"elastic_gas", 400u}, {"rain", 400u}}) {
        std::uint32_t before = 0;
        for (const auto preset : {BudgetPreset::fast, BudgetPreset::balanced, BudgetPreset::accurate}) {
            const BudgetQuestion question = question_of(name, balls, preset);
            const BudgetChoice choice = choose(question);
            CAPTURE(name, static_cast<int>(preset), choice.sentence);
            REQUIRE(choice.met);
            CHECK(choice.integrator == Integrator::leapfrog);
            CHECK(choice.measured.meets);
            CHECK(choice.measured.restitution <= question.budget.restitution);
            CHECK(choice.measured.overlap <= question.budget.overlap);
            CHECK(choice.measured.energy <= question.budget.energy);
            if (2 * choice.substeps <= choice.floor) {
                CHECK(rung(choice, 2 * choice.substeps).meets);
            }
            CHECK(question.probe.settings.dt / choice.substeps <= 0.9 * choice.critical_dt);
            REQUIRE(choice.binding);
            const auto cheaper =
                std::ranges::find_if(choice.tried, [&](const Rung& r) { return r.substeps >= choice.substeps; }) - 1;
            CHECK_FALSE((cheaper->meets && rung(choice, 2 * cheaper->substeps).meets));
            CHECK(choice.substeps > before);
            before = choice.substeps;
        }
    }
}

TEST_CASE("the critical substep is that of a close packing with a dashpot", "[budget]") {
    BudgetQuestion question = measure::budget_question(test::canonical_question(false, 8.0), BudgetPreset::balanced);
    CHECK(measure::critical_dt(question) == Approx(std::sqrt(0.5) * std::sqrt(1.0 / 1e4)));
    question.probe.settings.balls = 2;
    question.reading.emplace();
    question.reading->wall_contacts = 4.0;
    question.reading->max_stiffness = 4e4;  // a column: dt_c = 2 / w
    CHECK(measure::critical_dt(question) == Approx(0.01));
    // Two balls alone, w = sqrt(2 k / m): the limit of a spring and dashpot, h = 2 (sqrt(1 + z^2) - z).
    const double zeta = 0.2;
    const double c = 2.0 * zeta * std::sqrt(1e4 * 0.5);
    const auto limit = [](double z) { return 2.0 * (std::sqrt(1.0 + z * z) - z); };
    question.reading->max_stiffness = 2e4;
    question.reading->max_damping = 2.0 * c;
    CHECK(measure::critical_dt(question) * std::sqrt(2e4) == Approx(limit(zeta)));
    // Held by 8 k and 8 c of a packing, as long as nothing is known.
    question.reading.reset();
    question.probe.settings.limit_force = false;
    question.probe.scene.restitution = restitution_from_damping_ratio(zeta, false);
    CHECK(measure::critical_dt(question) * std::sqrt(8e4) == Approx(limit(2.0 * zeta)));
    BudgetQuestion wall = measure::budget_question(test::canonical_question(true, 8.0), BudgetPreset::balanced);
    CHECK(measure::critical_dt(wall) == Approx(0.02));
}

TEST_CASE("a stiffer network needs more substeps", "[budget]") {
    BudgetQuestion question = question_of("pile", 300, BudgetPreset::fast);
    const std::uint32_t loose = choose(question).substeps;
    question.reading.emplace();
    question.reading->max_stiffness = 128.0 * question.probe.settings.stiffness / question.probe.scene.mass;
    const BudgetChoice choice = choose(question);
    CHECK(choice.substeps > loose);
    CHECK(choice.binding == Demand::stability);
}

TEST_CASE("of a pile that has settled the budget takes the contacts as they are, as the gauge does", "[budget]") {
    const test::SettledPile pile = test::with_restitution(test::settled_pile(false, 100), 0.5);
    Settings settings = pile.scene.settings;
    settings.dt = 1.0 / 60.0;
    const Box box{-pile.scene.half_extent, pile.scene.half_extent};
    BudgetQuestion question = measure::budget_question(
        {settings, measure::probe_scene(pile.state, settings, box, variety_of(pile.state))}, BudgetPreset::fast);
    const double assumed = measure::critical_dt(question);
    CHECK(choose(question).sentence.find("is that of twelve neighbours a ball: too few touch") != std::string::npos);
    question.reading = test::reading_of(pile);
    const double gauge = test::gauge_critical_dt(pile);
    CHECK(gauge != Approx(assumed).epsilon(0.005));
    CHECK(measure::critical_dt(question) == Approx(gauge));
    const BudgetChoice choice = choose(question);
    CHECK(choice.network_measured);
    CHECK(choice.critical_dt == Approx(gauge));
    CHECK(choice.sentence.find("is that of the contacts as they are") != std::string::npos);
    // A few that touch, softer than what is to come, do not make a network.
    question.reading->contact_ends = question.reading->wall_contacts = 20.0;
    question.reading->max_stiffness = 2.0 * settings.stiffness;
    CHECK(measure::critical_dt(question) == Approx(assumed));
    CHECK_FALSE(choose(question).network_measured);
    question.reading = MeterReading{};
    CHECK(measure::critical_dt(question) == Approx(assumed));
}

TEST_CASE("integrators that heat every contact are not chosen, but can be measured", "[budget]") {
    BudgetQuestion question = question_of("historical", 300, BudgetPreset::balanced);
    REQUIRE(question.probe.settings.integrator == Integrator::historical);
    CHECK(choose(question).integrator == Integrator::leapfrog);
    question.probe.settings.integrator = Integrator::velocity_verlet;
    CHECK(choose(question).integrator == Integrator::velocity_verlet);
    const BudgetChoice seed = choose(question_of("elastic_gas", 300, BudgetPreset::historical));
    CHECK(seed.integrator == Integrator::historical);
    CHECK(seed.substeps == 8);
    CHECK_FALSE(seed.met);
    CHECK(seed.measured.restitution > 0.3);  // exp(pi^2 / 4 Nc) - 1 at Nc = 7 of balls, 9.8 of walls
}

TEST_CASE("substeps below the floor of floats are refused", "[budget]") {
    BudgetQuestion question = measure::budget_question(test::canonical_question(true, 4.0), BudgetPreset::accurate);
    const double ulp = 1.1920929e-7;  // at 1 m
    const double step = question.probe.settings.dt;
    CHECK(measure::float_floor(question) == static_cast<std::uint32_t>(step * 2.0 * 0.001 / ulp));
    question.probe.scene.distance = 64.0;
    const BudgetChoice choice = choose(question);
    CHECK(choice.floor == static_cast<std::uint32_t>(step * 2.0 * 0.001 / (64.0 * ulp)));
    CHECK(choice.floor < 16);
    CHECK_FALSE(choice.met);
    for (const Rung& rung : choice.tried) {
        CHECK(rung.substeps <= choice.floor);
    }
    CHECK(choice.sentence.find("only add rounding") != std::string::npos);
    CHECK(choice.sentence.find("compensated") != std::string::npos);
    question.probe.settings.laws.compensated = true;  // keeps what rounding leaves out: there is no such floor
    const BudgetChoice kept = choose(question);
    CHECK(kept.floor == 0);
    CHECK(kept.met);
    CHECK(kept.substeps > choice.floor);
    CHECK(kept.measured.restitution <= 0.001);
}

TEST_CASE("contacts too long to be run set no trap", "[budget]") {
    BudgetQuestion question = question_of("rain", 100, BudgetPreset::balanced);
    question.probe.settings.stiffness = 1.0;  // seconds of contact
    const BudgetChoice choice = choose(question);
    for (const Rung& rung : choice.tried) {
        CHECK((!rung.probed || rung.restitution > 0.0));
    }
    CHECK(choice.substeps < 64);
}

TEST_CASE("the sentence says what decides and what would fit", "[budget]") {
    BudgetQuestion question = question_of("elastic_gas", 400, BudgetPreset::balanced);
    question.substep_ms = 0.1;
    CHECK(choose(question).sentence.find("Restitution decides: with 8,") != std::string::npos);
    CHECK(choose(question).sentence.find("It takes 1.2 ms of a step's 16.7 ms") != std::string::npos);
    CHECK(choose(question).sentence.find("to fit") == std::string::npos);
    question.substep_ms = 2.0 * 1000.0 / 60.0 / 12.0;  // twice as long as a step
    const std::string sentence = choose(question).sentence;
    CHECK(sentence.find("to fit, about 200 balls, a stiffness of 2.5e+04 N/m or balls 1.59 times as large") !=
          std::string::npos);
    const BudgetChoice nothing = choose(question_of("free_fall", 100, BudgetPreset::fast));
    CHECK(nothing.nothing);
    CHECK(nothing.substeps == test::shipped_scene("free_fall").settings.substeps);
    CHECK(nothing.sentence.find("nothing touches") == 0);
    const BudgetChoice soft = choose(question_of("historical", 300, BudgetPreset::fast));
    CHECK(soft.softness > 1.0);
    CHECK(soft.sentence.find("pass through each other") != std::string::npos);
}

TEST_CASE("what falls is as fast as it will be, and rates are those of a gas", "[budget]") {
    Settings settings;
    settings.laws.gravity = settings.laws.walls = settings.laws.contact = true;
    BallState state;
    add_ball(state, {{0, 0, 4.0}, {0, 3, 0}, 0.5, 2.0, {}});
    add_ball(state, {{0, 0, -4.5}, {1, 0, 0}, 0.25, 1.0, {}});
    const Box box(dvec3(5.0));
    const auto scene = measure::probe_scene(state, settings, box, variety_of(state));
    CHECK(scene.radius == 0.25);
    CHECK(scene.mass == 1.0);
    CHECK(scene.distance == 5.0);
    CHECK(scene.largest_speed == Approx(std::sqrt(9.0 + 2.0 * 9.8 * 8.5)));
    CHECK(scene.typical_speed == Approx(std::sqrt(0.5 * (9.0 + 9.8 * 8.5 + 1.0 + 9.8 * 0.25))));
    settings.laws.drag = true;
    settings.drag = 9.8;  // 1 m/s
    CHECK(measure::probe_scene(state, settings, box, variety_of(state)).largest_speed == 3.0);
    settings.laws.gravity = settings.laws.drag = false;
    state.velocities[0].y = state.velocities[1].x = 0.0f;
    CHECK(measure::probe_scene(state, settings, box, variety_of(state)).speed_is_assumed);

    const BudgetQuestion gas = question_of("elastic_gas", 3000, BudgetPreset::balanced);
    const double n = 3000.0 / (8.0 * 8.0 * 8.0);  // the fill leaves no room free
    const double f = n * 4.0 / 3.0 * std::numbers::pi * 0.001;
    const double chi = (1.0 - f / 2.0) / std::pow(1.0 - f, 3.0);
    CHECK(gas.probe.scene.typical_speed == Approx(2.0).epsilon(1e-6));
    CHECK(gas.probe.scene.largest_speed == Approx(2.0 * std::sqrt(2.0 / 3.0 * std::log(3000.0))).epsilon(1e-6));
    CHECK(gas.probe.scene.pair_rate ==
          Approx(4.0 * n * 0.04 * chi * std::sqrt(std::numbers::pi * 4.0 / 3.0)).epsilon(0.01));
    CHECK(gas.probe.scene.wall_rate ==
          Approx(0.25 * std::sqrt(8.0 / std::numbers::pi * 4.0 / 3.0) * 6.0 / 8.0).epsilon(1e-6));
}
