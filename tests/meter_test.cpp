// Meters, energy balance and gauges against closed forms.
#include "core/meter.h"

#include <cmath>
#include <numbers>

#include "core/contact.h"
#include "core/simulation.h"
#include "cpu/cpu_backend.h"
#include "measure/energy.h"
#include "measure/energy_balance.h"
#include "measure/stability.h"
#include "support/catch.h"
#include "support/law_scenes.h"
#include "support/meter_contract.h"
#include "support/scenes.h"

using namespace ballpit;
using measure::Balance;
using measure::EnergyBalance;

namespace {

constexpr double stiffness = 1e4;  // N/m, of balls of 1 kg and 0.1 m
constexpr double gravity = 9.8;

std::unique_ptr<Backend> reference() { return std::make_unique<cpu::CpuBackend<double>>(); }
std::unique_ptr<Backend> mirror() { return std::make_unique<cpu::CpuBackend<float>>(); }

Scene scene_of(std::string_view laws, std::vector<BallSpec> balls, double dt) {
    Scene scene;
    scene.half_extent = dvec3(4.0);
    scene.settings.laws = parse_laws(laws);
    scene.settings.stiffness = stiffness;
    scene.settings.substeps = 1;
    scene.settings.dt = dt;
    scene.settings.balls = static_cast<std::uint32_t>(balls.size());
    scene.balls = std::move(balls);
    return scene;
}

BallSpec ball(const dvec3& position, const dvec3& velocity, double radius = 0.1, double mass = 1.0) {
    return {position, velocity, radius, mass, std::nullopt};
}

// Runs metered to the end, the last moment included.
Balance balance_after(Simulation& simulation, int substeps, EnergyBalance& balance) {
    simulation.set_metering(true);
    for (int i = 0; i < substeps; ++i) {
        simulation.substep();
    }
    simulation.meter();
    for (const MeterRecord& record : simulation.take_records()) {
        balance.add(record);
    }
    return balance.balance().value();
}

Balance balance_after(const Scene& scene, int substeps) {
    Simulation simulation(scene, scene.settings, 1, reference());
    EnergyBalance balance;
    return balance_after(simulation, substeps, balance);
}

// Of det(sum n n^T - x), by bisection from above its trace down to where the polynomial changes sign.
double largest_root(const std::vector<dvec3>& directions) {
    const auto determinant = [&](double x) {
        glm::dmat3 sum(0.0);
        for (const dvec3& direction : directions) {
            const dvec3 n = glm::normalize(direction);
            sum += glm::outerProduct(n, n);
        }
        return glm::determinant(sum - glm::dmat3(x));
    };
    double high = static_cast<double>(directions.size());
    double low = high;
    while (determinant(low) < 0.0) {
        low -= 1e-3;
    }
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (determinant(middle) < 0.0 ? high : low) = middle;
    }
    return low;
}

MeterRecord record_now(Simulation& simulation) {
    simulation.set_metering(true);
    simulation.meter();
    return simulation.take_records().back();
}

MeterReading reading_of_balls(const Scene& scene) {
    Simulation simulation(scene, scene.settings, 1, reference());
    return record_now(simulation).reading;
}

}  // namespace

TEST_CASE("the CPU's readings arrive in order and change nothing", "[meter]") {
    test::readings_arrive_in_order(mirror);
    test::metering_changes_nothing(mirror);
    test::metering_changes_nothing(reference);
}

TEST_CASE("readings agree with the sums over a state", "[meter]") {
    for (const char* name : {"pile", "rain", "mixed_sizes", "projectile_with_drag", "elastic_gas"}) {
        INFO(name);
        Scene scene = test::shipped_scene(name);
        scene.settings.balls = std::min(scene.settings.balls, 600u);
        Simulation simulation(scene, scene.settings, 1, mirror());
        for (int i = 0; i < 31; ++i) {
            simulation.substep();
        }
        const MeterReading reading = record_now(simulation).reading;
        const auto totals = measure::totals_of(simulation.synchronised_state(), simulation.settings(),
                                               simulation.features(), simulation.box());
        CHECK(reading.kinetic == Approx(totals.kinetic).epsilon(1e-5));
        CHECK(reading.potential == Approx(totals.potential).epsilon(1e-5).margin(1e-6));
        CHECK(reading.elastic == Approx(totals.elastic).epsilon(1e-3));
        CHECK(glm::length(reading.momentum - totals.momentum) < 1e-5 * reading.mass * reading.max_speed);
        CHECK(reading.contact_ends == 2.0 * totals.contacts);
        CHECK(reading.max_overlap == Approx(totals.max_overlap).epsilon(1e-3));
    }
}

TEST_CASE("a bounce with a dashpot leaves (1 - e^2) of its energy as heat", "[meter]") {
    for (const double e : {0.9, 0.6}) {
        for (const double n : {32.0, 128.0}) {  // substeps a contact
            Scene scene = scene_of("walls,restitution", {ball({-3.8, 0, 0}, {-1, 0, 0})}, 0.0);
            scene.settings.restitution = e;
            scene.settings.dt = std::numbers::pi / (std::sqrt(stiffness) * n);
            const Balance balance = balance_after(scene, static_cast<int>(0.2 / scene.settings.dt));
            INFO("e " << e << ", " << n << " substeps a contact");
            CHECK(balance.elastic == 0.0);
            const double zeta = damping_ratio_from_restitution(e, true);
            // Twice the error of e (docs/accuracy.md), because energy goes with its square.
            CHECK(balance.wall_heat ==
                  Approx(0.5 * (1.0 - e * e)).margin(e * 1.2 * 2.0 * std::numbers::pi * zeta * e / n));
            // The heat is what is missing, to the second order of the elastic part.
            CHECK(std::abs(balance.unexplained()) < 0.5 * 2.0 * 1.5 / (n * n));
        }
    }
}

TEST_CASE("balls that hit each other and walls leave the same heat where they should", "[meter]") {
    Scene scene =
        scene_of("contact,restitution", {ball({-0.15, 0, 0}, {1, 0, 0}), ball({0.15, 0.05, 0}, {-1, 0, 0})}, 2e-4);
    scene.settings.restitution = 0.7;
    const Balance balance = balance_after(scene, 1000);
    CHECK(balance.wall_heat == 0.0);
    CHECK(balance.contact_heat > 0.2);
    CHECK(balance.contact_heat == Approx(1.0 - balance.kinetic).epsilon(1e-3));
    scene.settings.neighbours = NeighbourSearch::brute_force;
    CHECK(balance_after(scene, 1000).contact_heat == Approx(balance.contact_heat).epsilon(1e-9));
}

TEST_CASE("drag in free fall heats as much as the fall gives less what is kinetic", "[meter]") {
    Scene scene = scene_of("gravity,drag", {ball({0, 0, 3}, {0, 0, 0})}, 1.0 / 960.0);
    scene.settings.drag = 0.8;
    const Balance balance = balance_after(scene, 480);
    const double t = 0.5;
    const double g = scene.settings.drag;
    const double v = gravity / g * (1.0 - std::exp(-g * t));
    const double fallen = gravity / g * (t - (1.0 - std::exp(-g * t)) / g);
    CHECK(balance.potential == Approx(-gravity * fallen).epsilon(1e-5));
    CHECK(balance.drag_heat == Approx(gravity * fallen - 0.5 * v * v).epsilon(1e-5));
    CHECK(std::abs(balance.unexplained()) < 1e-5);
}

TEST_CASE("a wall that hits a ball does the work that the ball then has", "[meter]") {
    Scene scene = scene_of("walls", {ball({3.85, 0, 0}, {0, 0, 0})}, 1e-4);
    scene.settings.walls_high = {-0.3, 0, 0};
    scene.settings.wall_speed = 0.5;
    const Balance balance = balance_after(scene, 1900);
    CHECK(balance.kinetic == Approx(0.5 * 1.0 * 1.0).epsilon(1e-3));  // at twice the speed of the wall
    CHECK(balance.work == Approx(balance.kinetic).epsilon(1e-3));
    CHECK(balance.wall_heat == 0.0);
    scene.settings.laws.restitution = true;
    scene.settings.restitution = 0.5;
    const Balance damped = balance_after(scene, 1900);
    CHECK(damped.wall_heat > 0.02);
    CHECK(damped.work - damped.wall_heat == Approx(damped.kinetic).epsilon(5e-3));
}

TEST_CASE("what a hand puts in is work", "[meter]") {
    for (const char* laws : {"none", "contact"}) {  // in place, and not
        Scene scene = scene_of(laws, {ball({0, 0, 0}, {0, 0, 0}), ball({2, 2, 2}, {0, 0, 0})}, 5e-4);
        scene.settings.pull = Pull{0, {1, 0, 0}};
        const Balance balance = balance_after(scene, 150);
        CHECK(balance.kinetic > 1.0);
        CHECK(balance.work == Approx(balance.kinetic).epsilon(1e-3));
    }
}

TEST_CASE("what the historical integrator makes is unexplained", "[meter]") {
    Scene scene = scene_of("walls", {ball({-3.8, 0, 0}, {-1, 0, 0})}, std::numbers::pi / 100.0 / 50.0);
    const Balance leapfrog = balance_after(scene, 400);
    CHECK(std::abs(leapfrog.unexplained()) < 1.3 / 2500.0);
    scene.settings.integrator = Integrator::historical;
    const Balance historical = balance_after(scene, 400);
    const double gain = std::exp(std::numbers::pi * std::numbers::pi / 200.0);
    CHECK(historical.unexplained() == Approx(0.5 * (gain * gain - 1.0)).epsilon(0.03));
    CHECK(historical.wall_heat == 0.0);
}

TEST_CASE("a ball at rest presses with its weight", "[meter]") {
    Scene scene = scene_of("gravity,walls,contact", {ball({0, 0, -3.9 - gravity / stiffness}, {0, 0, 0})}, 1e-3);
    Simulation simulation(scene, scene.settings, 1, reference());
    const MeterRecord record = record_now(simulation);
    CHECK(record.reading.floor_force == Approx(gravity).epsilon(1e-3));
    CHECK(record.weight() == Approx(gravity));
    CHECK(record.reading.wall_contacts == 1.0);
    CHECK(record.reading.max_overlap_share == Approx(gravity / stiffness / 0.2).epsilon(1e-3));
    CHECK(record.reading.max_stiffness == Approx(stiffness));
}

TEST_CASE("how stiffly a ball is held is the largest eigenvalue of its contacts", "[meter]") {
    // Two contacts 60 degrees apart: 2 k (1 + cos 60) / m.
    const double s = 0.5 * std::sqrt(3.0) * 0.19;
    const Scene two = scene_of("contact", {ball({0, 0, 0}, {}), ball({0.19, 0, 0}, {}), ball({0.095, s, 0}, {})}, 1e-3);
    CHECK(reading_of_balls(two).max_stiffness == Approx(3.0 * stiffness).epsilon(1e-5));
    Scene damped = two;
    damped.settings.laws.restitution = true;
    damped.settings.restitution = 0.5;
    const double c = 2.0 * 0.2552756376 * std::sqrt(stiffness * 0.5);
    CHECK(reading_of_balls(damped).max_damping == Approx(3.0 * c).epsilon(1e-5));
    // Three that are askew: k times the largest root of the cubic, found by bisection.
    const Scene askew = scene_of("contact",
                                 {ball({0, 0, 0}, {}), ball({0.18, 0.02, 0.01}, {}), ball({0.05, 0.17, -0.03}, {}),
                                  ball({-0.06, 0.04, 0.16}, {})},
                                 1e-3);
    CHECK(reading_of_balls(askew).max_stiffness ==
          Approx(2.0 * stiffness * largest_root({{0.18, 0.02, 0.01}, {0.05, 0.17, -0.03}, {-0.06, 0.04, 0.16}}))
              .epsilon(1e-5));
    // Three at right angles: each direction alone.
    const Scene three = scene_of("contact",
                                 {ball({0, 0, 0}, {}, 0.1, 0.5), ball({0.19, 0, 0}, {}, 0.1, 9.0),
                                  ball({0, 0.19, 0}, {}, 0.1, 9.0), ball({0, 0, 0.19}, {}, 0.1, 9.0)},
                                 1e-3);
    CHECK(reading_of_balls(three).max_stiffness == Approx(2.0 * stiffness / 0.5).epsilon(1e-5));
    // A row of two between walls: a ball and a wall along the same line add up.
    const Scene row = scene_of("contact,walls", {ball({-3.95, 0, 0}, {}), ball({-3.76, 0, 0}, {})}, 1e-3);
    CHECK(reading_of_balls(row).max_stiffness == Approx(3.0 * stiffness).epsilon(1e-5));
}

TEST_CASE("a change that moves energy begins a new run of records", "[meter]") {
    const Scene scene = test::mono_pile_scene(40);
    Simulation simulation(scene, scene.settings, 1, mirror());
    simulation.set_metering(true);
    const auto run_after = [&](const auto& change) {
        Settings settings = simulation.settings();
        change(settings);
        simulation.change(settings);
        simulation.substep();
        const std::vector<MeterRecord> records = simulation.take_records();
        REQUIRE(records.size() == 1);
        return records.back().run;
    };
    const std::uint64_t first = run_after([](Settings&) {});
    CHECK(run_after([](Settings& s) { s.dt *= 0.5; }) == first);
    CHECK(run_after([](Settings& s) { s.pull = Pull{3, dvec3(0.0)}; }) == first);
    CHECK(run_after([](Settings& s) { s.walls_low.x = 0.1; }) == first);
    const std::uint64_t stiffer = run_after([](Settings& s) { s.stiffness *= 2.0; });
    CHECK(stiffer != first);
    const std::uint64_t other = run_after([](Settings& s) { s.integrator = Integrator::historical; });
    CHECK(other != stiffer);
    const std::uint64_t fewer = run_after([](Settings& s) { s.balls = 20; });
    CHECK(fewer != other);
    const Checkpoint checkpoint = simulation.checkpoint();
    simulation.substep();
    simulation.restore(checkpoint);
    simulation.substep();
    CHECK(simulation.take_records().back().run != fewer);
}

TEST_CASE("a balance begins anew with each run, and time may turn back", "[meter]") {
    EnergyBalance balance;
    MeterRecord record;
    record.reading.kinetic = 5.0;
    record.reading.contact_heat = 2.0;
    balance.add(record);
    record.time = 0.5;
    record.reading.kinetic = 4.0;
    balance.add(record);
    CHECK(balance.balance()->contact_heat == 1.0);
    CHECK(balance.balance()->unexplained() == 0.0);
    record.run = 1;
    record.time = 1.0;
    CHECK(balance.add(record).contact_heat == 0.0);
    CHECK(balance.balance()->base_time == 1.0);
    record.time = 0.25;
    CHECK(balance.add(record).base_time == 0.25);
}

TEST_CASE("a series keeps few points of one base, in the order of time", "[meter]") {
    measure::BalanceSeries series;
    for (int i = 0; i < 100000; ++i) {
        Balance balance;
        balance.time = i;
        series.add(balance);
    }
    CHECK(series.points().size() <= measure::BalanceSeries::capacity);
    CHECK(series.points().size() >= measure::BalanceSeries::capacity / 4);
    CHECK(series.points().front().time == 0.0);
    CHECK(series.points().back().time > 99000.0);
    for (std::size_t i = 1; i < series.points().size(); ++i) {
        REQUIRE(series.points()[i - 1].time < series.points()[i].time);
    }
    Balance back;
    back.time = back.base_time = 500.5;
    series.add(back);
    REQUIRE(series.points().size() == 1);
    CHECK(series.points().back().time == 500.5);
}

TEST_CASE("readings that are lost lose their moments, too", "[meter]") {
    MeterQueue queue;
    MeterRecord moment;
    for (moment.step = 0; moment.step < 4; ++moment.step) {
        queue.add(moment);
    }
    const std::vector<TaggedReading> readings{{1, {}}, {3, {}}};
    const auto records = queue.match(readings);
    REQUIRE(records.size() == 2);
    CHECK(records[0].step == 1);
    CHECK(records[1].step == 3);
    CHECK(queue.match(readings).empty());
}
