// The gauges: their numbers, their remedies, and whether the one of dt / dt_c is to be believed.
#include "measure/stability.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/world.h"
#include "support/catch.h"
#include "support/piles.h"

using namespace ballpit;
using measure::Gauge;
using measure::Light;

namespace {

// A ball of 1 kg and 0.1 m held by 2 k: omega = sqrt(2e4) 1/s.
MeterRecord resting() {
    MeterRecord record;
    record.dt = 1e-3;
    record.drag = 0.1;
    record.gravity = {0, 0, -9.8};
    record.reading.mass = 1.0;
    record.reading.kinetic = 0.5;
    record.reading.max_stiffness = 2e4;
    record.reading.max_lightness = 1.0;
    record.reading.max_speed = 1.0;
    record.reading.max_speed_share = 5.0;
    return record;
}

Settings settings_of(double dt, std::uint32_t substeps) {
    Settings settings;
    settings.laws = parse_laws("gravity,drag,contact,walls");
    settings.stiffness = 1e4;
    settings.dt = dt;
    settings.substeps = substeps;
    return settings;
}

Grid grid_of(double width) {
    Grid grid;
    grid.cell_width = width;
    return grid;
}

std::vector<Gauge> gauges_of(const MeterRecord& record, const Settings& settings, double cell = 0.2) {
    return measure::gauges(record, settings, grid_of(cell), 0.1, 4.0);
}

Gauge gauge(const std::vector<Gauge>& all, std::string_view name) {
    const auto found = std::ranges::find(all, name, &Gauge::name);
    INFO(name);
    REQUIRE(found != all.end());
    return *found;
}

// What the gauge says once its own remedy has been taken.
Light light_after_remedy(const MeterRecord& record, Settings settings, std::string_view name) {
    const Gauge before = gauge(gauges_of(record, settings), name);
    REQUIRE(before.remedy.has_value());
    assign_setting(settings, before.remedy->key, before.remedy->value);
    const auto after = gauges_of(record, settings);
    const auto found = std::ranges::find(after, name, &Gauge::name);
    return found == after.end() ? Light::green : found->light();
}

}  // namespace

TEST_CASE("the critical substep is that of an oscillator, less where it is damped", "[stability]") {
    CHECK(measure::critical_dt(100.0, 0.0) == Approx(0.02));
    // Z = 1: symplectic Euler's h_c at zeta = 1 is 0.828.
    CHECK(100.0 * measure::critical_dt(100.0, 200.0) == Approx(2.0 * (std::sqrt(2.0) - 1.0)));
    CHECK(std::isinf(measure::critical_dt(0.0, 0.0)));
}

TEST_CASE("gauges say their numbers and turn with their limits", "[stability]") {
    const auto at = [](double dt) { return gauges_of(resting(), settings_of(dt, 1)); };
    const double critical = 2.0 / std::sqrt(2e4);
    CHECK(gauge(at(0.4 * critical), "dt / dt_c").value == Approx(0.4));
    CHECK(gauge(at(0.49 * critical), "dt / dt_c").light() == Light::green);
    CHECK(gauge(at(0.51 * critical), "dt / dt_c").light() == Light::amber);
    CHECK(gauge(at(0.91 * critical), "dt / dt_c").light() == Light::red);
    const double contact = 3.14159265358979 / std::sqrt(2e4);
    CHECK(gauge(at(contact / 20.0), "substeps a contact").value == Approx(20.0));
    CHECK(gauge(at(contact / 20.0), "substeps a contact").light() == Light::green);
    CHECK(gauge(at(contact / 6.0), "substeps a contact").light() == Light::amber);
    CHECK(gauge(at(contact / 3.0), "substeps a contact").light() == Light::red);
    CHECK(gauge(at(0.04), "v dt / D").value == Approx(0.2));
    CHECK(gauge(at(0.2), "v dt / D").light() == Light::red);
    CHECK(gauge(at(0.5), "drag dt").value == Approx(0.05));
    // ulp(4) = 2^-21; 1.98 m/s is a fall through a diameter.
    CHECK(gauge(at(1e-3), "float floor").value ==
          Approx(0.5 * 0x1p-21 / (1e-3 * std::sqrt(2.0 * 9.8 * 0.2))).epsilon(1e-6));
    CHECK(gauge(at(1e-6), "float floor").light() == Light::red);
    CHECK(gauge(gauges_of(resting(), settings_of(1e-3, 1), 0.19), "cell / 2 r").light() == Light::red);
    CHECK(gauge(gauges_of(resting(), settings_of(1e-3, 1), 0.21), "cell / 2 r").light() == Light::green);
}

TEST_CASE("each gauge's remedy turns it green", "[stability]") {
    CHECK(light_after_remedy(resting(), settings_of(0.02, 1), "dt / dt_c") == Light::green);
    CHECK(light_after_remedy(resting(), settings_of(0.02, 3), "substeps a contact") == Light::green);
    CHECK(light_after_remedy(resting(), settings_of(0.1, 1), "v dt / D") == Light::green);
    CHECK(light_after_remedy(resting(), settings_of(1e-3, 64), "float floor") == Light::green);
    MeterRecord syrup = resting();
    syrup.drag = 50.0;
    Settings settings = settings_of(0.02, 2);
    CHECK(light_after_remedy(syrup, settings, "drag dt") == Light::green);
    settings.integrator = Integrator::historical;
    CHECK(light_after_remedy(resting(), settings, "c - k dt / 2") == Light::green);
    // What is green needs none, and what no setting can reach has none.
    CHECK_FALSE(gauge(gauges_of(resting(), settings_of(1e-3, 1)), "dt / dt_c").remedy.has_value());
    CHECK_FALSE(gauge(gauges_of(resting(), settings_of(100.0, 1024)), "dt / dt_c").remedy.has_value());
}

TEST_CASE("the historical integrator needs a dashpot of more than k dt / 2", "[stability]") {
    Settings settings = settings_of(1e-3, 1);
    settings.laws.restitution = true;
    settings.restitution = 0.5;
    settings.integrator = Integrator::historical;
    const double c = 2.0 * 0.2552756376 * std::sqrt(1e4 * 0.5);  // zeta of a force that never pulls
    CHECK(gauge(gauges_of(resting(), settings), "c - k dt / 2").value == Approx(c - 5.0).epsilon(1e-5));
    CHECK(gauge(gauges_of(resting(), settings), "c - k dt / 2").light() == Light::green);
    settings.dt = 0.01;
    CHECK(gauge(gauges_of(resting(), settings), "c - k dt / 2").light() == Light::red);
    settings.laws.restitution = false;
    settings.dt = 1e-5;
    CHECK(gauge(gauges_of(resting(), settings), "c - k dt / 2").light() == Light::red);
}

TEST_CASE("laws that are off have no gauges, and no balls none at all", "[stability]") {
    Settings settings = settings_of(1e-3, 1);
    settings.laws = parse_laws("gravity");
    const auto list = gauges_of(resting(), settings);
    REQUIRE(list.size() == 1);
    CHECK(list.front().name == "float floor");
    settings.laws.compensated = true;
    CHECK(gauges_of(resting(), settings).empty());
    CHECK(gauges_of(MeterRecord{}, settings_of(1e-3, 1)).empty());
    MeterRecord broken = resting();
    broken.reading.max_stiffness = std::nan("");
    broken.reading.max_speed_share = std::nan("");
    CHECK(gauge(gauges_of(broken, settings_of(1e-3, 1)), "v dt / D").light() == Light::red);
}

TEST_CASE("before anything touches, twelve neighbours of the lightest ball are expected", "[stability]") {
    MeterRecord falling = resting();
    falling.reading.max_stiffness = 0.0;
    CHECK(measure::stiffest_mode(falling.reading, settings_of(1e-3, 1)) == Approx(std::sqrt(8e4)));
}

// `./run statistics` has more piles, and longer. At rest only rounding moves them, the same at any stable substep; what
// is not stable grows by 2 acosh(dt / dt_c) a substep.
TEST_CASE("a pile stays at rest below the gauge's red line and grows above the true limit", "[stability]") {
    constexpr int substeps = 300;
    for (const bool unequal : {false, true}) {
        const test::SettledPile settled = test::settled_pile(unequal, 100);
        for (const double restitution : {1.0, 0.5}) {
            const test::SettledPile pile = test::with_restitution(settled, restitution);
            const double critical = test::true_critical_dt(pile);
            const double gauge = test::gauge_critical_dt(pile);
            const double quiet = test::agitation(pile, 0.25 * gauge, substeps);
            INFO((unequal ? "radii 1 : 2, e = " : "equal radii, e = ")
                 << restitution << ", true dt_c " << critical << " s, gauge " << gauge << " s, quiet " << quiet);
            CHECK(gauge < critical);
            CHECK(gauge > 0.65 * critical);
            CHECK(test::agitation(pile, 0.9 * gauge, substeps) < 10.0 * quiet);
            CHECK(test::agitation(pile, 0.99 * critical, substeps) < 10.0 * quiet);
            CHECK(test::agitation(pile, 1.1 * critical, substeps) > 100.0 * quiet);
        }
    }
}
