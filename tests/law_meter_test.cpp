// Costs of laws on the mirror, and the numbers behind a cost.
#include <vector>

#include "cpu/cpu_backend.h"
#include "support/law_meter_contract.h"

using namespace ballpit;

TEST_CASE("the mirror's laws are measured, and the simulation does not notice", "[laws]") {
    test::measures_every_law([] { return std::make_unique<cpu::CpuBackend<float>>(); });
}

TEST_CASE("without balls there is nothing to measure", "[laws]") {
    const Scene scene = test::shipped_scene("rain");
    Settings settings = scene.settings;
    settings.balls = 0;
    Simulation simulation(scene, settings, 1, std::make_unique<cpu::CpuBackend<float>>());
    app::LawMeter meter;
    meter.start(simulation, std::make_unique<cpu::CpuBackend<float>>());
    CHECK_FALSE(meter.busy());
}

TEST_CASE("a law that runs no other program costs nothing", "[laws]") {
    Scene scene;
    scene.settings.laws = parse_laws("gravity");
    scene.settings.balls = 1;
    scene.balls.resize(1);
    Simulation simulation(scene, scene.settings, 1, std::make_unique<cpu::CpuBackend<float>>());
    app::LawMeter meter;
    meter.start(simulation, std::make_unique<cpu::CpuBackend<float>>());
    test::measure_all(meter);
    for (const char* key : {"restitution", "unequal_radii", "shake"}) {
        INFO(key);
        REQUIRE(meter.costs()[test::law_index(key)]);
        CHECK(meter.costs()[test::law_index(key)]->same_programs);
    }
    CHECK_FALSE(meter.costs()[test::law_index("contact")]->same_programs);
}

TEST_CASE("a plan is what the settings would run", "[laws]") {
    const Scene scene = test::shipped_scene("pile");
    Settings settings = scene.settings;
    settings.balls = 50;
    Simulation simulation(scene, settings, 1, std::make_unique<cpu::CpuBackend<float>>());
    simulation.step();
    Settings other = settings;
    other.laws.contact = false;
    other.laws.ball_restitution = true;
    const Plan plan = simulation.plan(other);
    CHECK(simulation.features().has(Feature::contact));
    simulation.change(other);
    CHECK(plan.schedule.features == simulation.features());
    CHECK(plan.schedule.in_place == simulation.schedule().in_place);
    CHECK(plan.schedule.dispatches.size() == simulation.schedule().dispatches.size());
    CHECK(plan.restitutions.size() == 50);
}

TEST_CASE("a law ticked on or off leaves every ball where it is", "[laws]") {
    const Scene scene = test::shipped_scene("pile");
    Settings settings = scene.settings;
    settings.balls = 200;
    Simulation simulation(scene, settings, 1, std::make_unique<cpu::CpuBackend<float>>());
    for (const LawInfo& law : law_table()) {
        simulation.step();
        const std::vector<vec4> before = simulation.raw_state().positions;
        settings.laws.*law.member = !(settings.laws.*law.member);
        simulation.change(settings);
        INFO(law.key);
        CHECK(simulation.raw_state().positions == before);
        CHECK(simulation.settings().laws == settings.laws);
    }
}

TEST_CASE("a paired cost is the median difference, known where it exceeds its uncertainty", "[laws]") {
    const std::vector<double> without = {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0};
    std::vector<double> with;
    for (const double ms : without) {
        with.push_back(ms + 0.5);  // whatever drifts, drifts in both
    }
    with[0] = 100.0;  // one outlier does no harm
    const measure::PairedCost cost = measure::paired_cost(with, without);
    CHECK(cost.ms == Approx(0.5));
    CHECK(cost.uncertainty == Approx(0.0).margin(1e-12));
    CHECK(cost.known);
    CHECK(cost.without_ms == 5.0);
    with = {1.5, 1.9, 3.5, 3.9, 5.5, 5.9, 7.5, 7.9, 9.0};
    CHECK_FALSE(measure::paired_cost(with, without).known);
}
