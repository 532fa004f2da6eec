// Balls that stay in the order of their cells: the schedule, and its dispatches on the mirror.
#include "core/hash.h"
#include "core/simulation.h"
#include "cpu/cpu_backend.h"
#include "support/catch.h"
#include "support/scenes.h"

using namespace ballpit;

namespace {

Settings counting(const Scene& scene, std::uint32_t balls) {
    Settings settings = scene.settings;
    settings.balls = scene.fill ? balls : settings.balls;
    settings.substeps = std::min(settings.substeps, 4u);
    settings.sort = SortMethod::counting;
    return settings;
}

std::vector<std::string> names_of(const Schedule& schedule) {
    std::vector<std::string> names;
    for (const Dispatch& dispatch : schedule.dispatches) {
        names.push_back(dispatch.name);
    }
    return names;
}

Schedule schedule_of(const Settings& settings) {
    return Simulation(test::shipped_scene("pile"), settings, 1, std::make_unique<cpu::CpuBackend<float>>()).schedule();
}

}  // namespace

TEST_CASE("whoever keeps the order has fewer dispatches, and needs a counting sort and copies", "[core]") {
    Settings settings = counting(test::shipped_scene("pile"), 300);
    settings.grid_reuse = 2;
    settings.laws.diagnostics = true;
    const Schedule plain = schedule_of(settings);
    REQUIRE(can_keep_order(plain));
    const Schedule kept = keeping_order(plain);
    CHECK(names_of(kept) == std::vector<std::string>{"clear_cells", "assign_cells", "count_tiles", "scan_cells",
                                                     "scatter_keys", "order_keys", "count_missed", "keep_places",
                                                     "collide"});
    CHECK(kept.dispatches.size() + 2 == plain.dispatches.size());
    CHECK(names_of(with_grid_reused(kept)) == std::vector<std::string>{"collide"});
    CHECK(with_grid_reused(kept).swaps_copies);
    CHECK_FALSE(kept.swaps_states);
    CHECK(names_of(there_and_back(plain)).front() == "start_order");
    CHECK(names_of(there_and_back(plain)).back() == "put_back");
    for (int without = 0; without < 3; ++without) {
        Settings other = settings;
        other.keep_order = without != 0;
        other.sorted_copies = without != 1;
        other.sort = without != 2 ? SortMethod::counting : SortMethod::bitonic_fused;
        CHECK_FALSE(can_keep_order(schedule_of(other)));
    }
}

TEST_CASE("a substep that keeps the order reads and writes the state in that order alone", "[core]") {
    const Schedule kept = keeping_order(schedule_of(counting(test::shipped_scene("pile"), 300)));
    for (const Dispatch& dispatch : kept.dispatches) {
        for (const auto* slots : {&dispatch.reads, &dispatch.writes}) {
            CAPTURE(dispatch.name);
            CHECK(std::ranges::count(*slots, Slot::positions) == 0);
            CHECK(std::ranges::count(*slots, Slot::velocities) == 0);
        }
    }
}

TEMPLATE_TEST_CASE("mirror: there and back gives the bits of the plain substep, in every scene", "[mirror]", float,
                   double) {
    for (const std::string_view name : test::shipped_scene_names) {
        const Scene scene = test::shipped_scene(name);
        const Settings settings = counting(scene, 200);
        Simulation plain(scene, settings, 1, std::make_unique<cpu::CpuBackend<TestType>>());
        Simulation kept(scene, settings, 1, std::make_unique<cpu::CpuBackend<TestType>>());
        if (!can_keep_order(plain.schedule())) {
            continue;
        }
        for (int i = 0; i < 40; ++i) {
            plain.substep();
            const Schedule schedule = there_and_back(kept.schedule());
            kept.begin_substep();
            kept.backend().run(schedule, kept.params(), 0, schedule.dispatches.size());
            kept.end_substep(schedule);
        }
        CAPTURE(name);
        CHECK(hash_state(kept.raw_state()) == hash_state(plain.raw_state()));
    }
}

TEST_CASE("mirror: contacts that a used grid missed are the same in both orders", "[mirror]") {
    Settings settings = counting(test::shipped_scene("rain"), 400);
    settings.laws.diagnostics = true;
    settings.grid_reuse = 4;
    const auto missed = [&](bool keep) {
        Simulation simulation(test::shipped_scene("rain"), settings, 1, std::make_unique<cpu::CpuBackend<float>>());
        for (int i = 0; i < 1200; ++i) {
            const bool there = keep && simulation.builds_grid();
            const Schedule schedule = there ? there_and_back(simulation.schedule()) : simulation.schedule();
            simulation.begin_substep();
            simulation.backend().run(schedule, simulation.params(), 0, schedule.dispatches.size());
            simulation.end_substep(schedule);
        }
        return read_slot<Status>(simulation.backend(), Slot::status).front();
    };
    const Status plain = missed(false);
    const Status kept = missed(true);
    CHECK(plain.missed > 0);
    CHECK(kept.missed == plain.missed);
    CHECK(kept.drift_bits == plain.drift_bits);
}
