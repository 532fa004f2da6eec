#include "measure/extreme_trial.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "core/extremes.h"
#include "measure/invariants.h"
#include "measure/warnings.h"

namespace ballpit::measure {

void ExtremeTrial::expect(bool holds, std::string found) { claims_.push_back({holds, std::move(found)}); }

void ExtremeTrial::require(bool holds, std::string otherwise) {
    if (!holds) {
        expect(false, std::move(otherwise));
    }
}

void ExtremeTrial::at_most(const std::string& what, double found, double most, std::string_view unit) {
    expect(found <= most, what + " " + digits(found) + std::string(unit) + " (at most " + digits(most) + ")");
}

void ExtremeTrial::at_least(const std::string& what, double found, double least, std::string_view unit) {
    expect(found >= least, what + " " + digits(found) + std::string(unit) + " (at least " + digits(least) + ")");
}

void ExtremeTrial::near(const std::string& what, double found, double expected, double share, std::string_view unit) {
    expect(std::abs(found - expected) <= share * std::abs(expected),
           what + " " + digits(found) + std::string(unit) + " (exact " + digits(expected) + ")");
}

void ExtremeTrial::note(const ExtremeSign& sign) {
    const auto known = std::ranges::find(signs_, sign.key, &ExtremeSign::key);
    if (known == signs_.end()) {
        signs_.push_back(sign);
    } else {
        known->number = std::max(known->number, sign.number);
    }
}

void ExtremeTrial::note_signs(Simulation& simulation) {
    for (const ExtremeSign& sign : signs_of(simulation)) {
        note(sign);
    }
}

void ExtremeTrial::expect_sign(Simulation& simulation, std::string_view key) {
    const std::vector<ExtremeSign> signs = signs_of(simulation);
    const auto found = std::ranges::find(signs, key, &ExtremeSign::key);
    expect(found != signs.end(), found != signs.end() ? "told as " + std::string(key) + " " + digits(found->number)
                                                      : "nothing told as " + std::string(key));
    for (const ExtremeSign& sign : signs) {
        note(sign);
    }
}

void ExtremeTrial::expect_no_sign(Simulation& simulation) {
    const std::vector<ExtremeSign> signs = signs_of(simulation);
    expect(signs.empty(), signs.empty() ? "no warning" : "a warning of " + signs.front().key);
    for (const ExtremeSign& sign : signs) {
        note(sign);
    }
}

void ExtremeTrial::expect_no_sign(Simulation& simulation, std::string_view key) {
    const std::vector<ExtremeSign> signs = signs_of(simulation);
    expect(std::ranges::find(signs, key, &ExtremeSign::key) == signs.end(), "no " + std::string(key));
}

std::string digits(double value) {
    std::string text(32, '\0');
    text.resize(static_cast<std::size_t>(std::snprintf(text.data(), text.size(), "%.4g", value)));
    return text;
}

Scene extreme_scene(std::string_view laws, double half_extent) {
    Scene scene;
    scene.name = "extreme";
    scene.half_extent = dvec3(half_extent);
    scene.settings.laws = parse_laws(laws);
    scene.settings.laws.diagnostics = true;
    scene.settings.restitution = 1.0;
    return scene;
}

void put_ball(Scene& scene, const dvec3& position, const dvec3& velocity, double radius, double mass) {
    scene.balls.push_back({position, velocity, radius, mass, std::nullopt});
    ++scene.settings.balls;
}

void fill_region(Scene& scene, std::uint32_t count, const std::array<double, 2>& radius, double speed,
                 const dvec3& lower, const dvec3& upper) {
    scene.fill = Fill{count, radius, 1000.0, speed, {lower, upper}, 1};
    scene.settings.balls += count;
}

void run_steps(Simulation& simulation, std::uint64_t steps) {
    for (std::uint64_t i = 0; i < steps; ++i) {
        simulation.step();
    }
}

std::uint64_t hash_of(Simulation& simulation) { return hash_state(simulation.raw_state()); }

Totals totals_of(Simulation& simulation) {
    return totals_of(simulation.synchronised_state(), simulation.settings(), simulation.features(), simulation.box());
}

bool all_finite(const BallState& state) { return !all_finite(state.positions, state.velocities).has_value(); }

MeterRecord metered(Simulation& simulation) {
    const bool metering = simulation.metering();
    simulation.set_metering(true);
    simulation.take_records();
    simulation.meter();
    MeterRecord last;
    for (bool arrived = false; !arrived;) {
        simulation.backend().finish();
        for (const MeterRecord& record : simulation.take_records()) {
            last = record;
            arrived = record.step == simulation.step_count() && record.substep == simulation.substep_in_step();
        }
    }
    simulation.backend().take_reading_times();
    simulation.set_metering(metering);
    return last;
}

std::vector<ExtremeSign> signs_of(Simulation& simulation) {
    const MeterRecord record = metered(simulation);
    const ExtremeNumbers counted = counted_extremes(read_slot<Status>(simulation.backend(), Slot::status).front());
    const ExtremeNumbers warned = warnings_of(simulation, &record);
    std::vector<ExtremeSign> signs;
    for (const ExtremeInfo& info : extreme_table()) {
        const double number = info.counted ? counted[info.extreme] : warned[info.extreme];
        if (number != 0.0) {
            signs.push_back({std::string(info.key), number});
        }
    }
    return signs;
}

bool has_sign(Simulation& simulation, std::string_view key) {
    const std::vector<ExtremeSign> signs = signs_of(simulation);
    return std::ranges::find(signs, key, &ExtremeSign::key) != signs.end();
}

Gauge gauge_of(Simulation& simulation, std::string_view name) {
    const std::vector<Gauge> list = gauges(metered(simulation), simulation);
    const auto found = std::ranges::find(list, name, &Gauge::name);
    return found == list.end() ? Gauge{} : *found;
}

NeighbourReport grid_report(ExtremeTrial& trial, Simulation& simulation) {
    Backend& backend = simulation.backend();
    const Schedule& schedule = simulation.schedule();
    const auto collide = std::ranges::find(schedule.dispatches, Stage::collide, &Dispatch::stage);
    const auto first = static_cast<std::size_t>(collide - schedule.dispatches.begin());
    simulation.begin_substep();
    backend.run(schedule, simulation.params(), 0, first);
    const auto positions = read_slot<vec4>(backend, Slot::positions);
    const auto keys = read_slot<Key>(backend, Slot::keys);
    const auto ranges = read_slot<CellRange>(backend, Slot::cell_ranges);
    for (const Violation& violation :
         {keys_sorted(keys, schedule.ball_count), ranges_partition(ranges, keys, schedule.ball_count)}) {
        trial.require(!violation, violation.value_or(""));
    }
    NeighbourReport report = neighbour_report({positions, keys, ranges, schedule.grid});
    backend.run(schedule, simulation.params(), first, schedule.dispatches.size());
    simulation.end_substep();
    return report;
}

}  // namespace ballpit::measure
