// What measuring laws is held to on every backend.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <thread>

#include "app/law_meter.h"
#include "support/catch.h"
#include "support/scenes.h"

namespace ballpit::test {

using MakeBackend = std::function<std::unique_ptr<Backend>()>;

inline std::size_t law_index(std::string_view key) {
    return static_cast<std::size_t>(std::ranges::find(law_table(), key, &LawInfo::key) - law_table().begin());
}

inline void measure_all(app::LawMeter& meter) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    while (meter.busy()) {
        REQUIRE(std::chrono::steady_clock::now() < end);
        meter.update(5.0);
        std::this_thread::sleep_for(std::chrono::microseconds(200));  // times come late
    }
}

/// A pile in which contact costs most of a substep. Measuring leaves the simulation as it was.
inline void measures_every_law(const MakeBackend& make) {
    const Scene scene = shipped_scene("pile");
    Settings settings = scene.settings;
    settings.balls = 3000;
    Simulation simulation(scene, settings, 1, make());
    simulation.step();
    const std::uint64_t before = hash_state(simulation.raw_state());
    const std::uint64_t schedules = simulation.schedule_changes();
    app::LawMeter meter;
    meter.update(5.0);
    CHECK(meter.runs() == 0);  // closed: nothing runs
    meter.start(simulation, make());
    measure_all(meter);
    CHECK(hash_state(simulation.raw_state()) == before);
    CHECK(simulation.schedule_changes() == schedules);

    const auto& contact = meter.costs()[law_index("contact")];
    REQUIRE(contact);
    CHECK(contact->pairs.ms > 0.0);
    CHECK(contact->pairs.known);
    CHECK(contact->pairs.with_ms > 1.5 * contact->pairs.without_ms);
    REQUIRE(meter.substep_ms());
    CHECK(*meter.substep_ms() > 0.0);
    for (std::size_t i = 0; i < law_count; ++i) {
        INFO(law_table()[i].key);
        CHECK(meter.costs()[i].has_value());
    }
    const std::uint64_t runs = meter.runs();
    meter.update(5.0);
    CHECK(meter.runs() == runs);  // done: nothing more
}

}  // namespace ballpit::test
