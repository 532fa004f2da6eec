// What the views tell about neighbours, sort passes and tables, against counting by hand and brute force.
#include <algorithm>
#include <sstream>

#include "core/simulation.h"
#include "cpu/cpu_backend.h"
#include "measure/neighbours.h"
#include "measure/slot_table.h"
#include "measure/sort_pass.h"
#include "support/catch.h"
#include "support/stepping.h"

using namespace ballpit;
using namespace ballpit::measure;

namespace {

// A substep of a small scene, up to and including build_grid.
struct Built {
    explicit Built(double cell_factor)
        : simulation(test::stepping_simulation(std::make_unique<cpu::CpuBackend<float>>(), SortMethod::bitonic)) {
        for (int i = 0; i < 20; ++i) {
            simulation.step();
        }
        Settings settings = simulation.settings();
        settings.cell_factor = cell_factor;
        simulation.change(settings);
        const Schedule& schedule = simulation.schedule();
        simulation.backend().run(schedule, simulation.params(), 0, schedule.dispatches.size() - 1);
        positions = read_slot<vec4>(simulation.backend(), Slot::positions);
        keys = read_slot<Key>(simulation.backend(), Slot::keys);
        ranges = read_slot<CellRange>(simulation.backend(), Slot::cell_ranges);
    }
    GridView view() const { return {positions, keys, ranges, simulation.schedule().grid}; }

    Simulation simulation;
    std::vector<vec4> positions;
    std::vector<Key> keys;
    std::vector<CellRange> ranges;
};

}  // namespace

TEST_CASE("a grid of whole diameters misses no contact and tests fewer pairs than brute force", "[measure]") {
    const Built built(1.0);
    const auto grid = neighbour_report(built.view());
    const auto brute = brute_force_report(built.positions);
    CHECK(brute.contacts == brute_force_pairs(built.positions).size());
    CHECK(brute.tested == 41u * 40u);
    CHECK(brute.contacts > 0);
    CHECK(grid.contacts == brute.contacts);
    CHECK(grid.missed.empty());
    CHECK(grid.tested <= brute.tested);
    std::uint64_t tested = 0;
    std::size_t touched = 0;
    for (std::uint32_t ball = 0; ball < 41; ++ball) {
        const BallTrace trace = trace_ball(built.view(), ball);
        tested += trace.tested.size();
        touched += trace.touched.size();
        CHECK(built.keys[trace.slot].ball_id == ball);
        CHECK(trace.range.first <= trace.slot);
        CHECK(trace.slot < trace.range.end);
        CHECK(std::ranges::count(trace.cells, trace.cell_id) == 1);
    }
    CHECK(tested == grid.tested);
    CHECK(touched == 2 * grid.contacts);
}

TEST_CASE("cells of a quarter diameter miss contacts, and those that are missed do touch", "[measure]") {
    const Built built(0.25);
    const auto grid = neighbour_report(built.view());
    REQUIRE_FALSE(grid.missed.empty());
    CHECK(grid.contacts + grid.missed.size() == brute_force_pairs(built.positions).size());
    for (const Pair& pair : grid.missed) {
        CHECK(touching(built.positions[pair.a], built.positions[pair.b]));
        const auto tested = trace_ball(built.view(), pair.a).tested;
        CHECK(std::ranges::find(tested, pair.b) == tested.end());
    }
}

TEST_CASE("the passes of a sort are numbered in running order", "[measure]") {
    std::uint32_t number = 0;
    for (std::uint32_t k = 2; k <= 8192; k *= 2) {
        for (std::uint32_t j = k / 2; j > 0; j /= 2) {
            CHECK(pass_number(k, j) == ++number);
        }
    }
    CHECK(pass_count(8192) == number);
    CHECK(number == 91);
    CHECK(pass_count(1) == 0);
}

TEST_CASE("a pass swaps the pairs that the network exchanges, and equal keys never", "[measure]") {
    std::vector<Key> keys = {{5, 0}, {3, 1}, {9, 2}, {9, 3}, {SENTINEL, SENTINEL}, {SENTINEL, SENTINEL},
                             {1, 4}, {2, 5}};
    // k = 2, j = 1: pairs (0,1) up, (2,3) down, (4,5) up, (6,7) down.
    CHECK(count_swaps(2, 1, keys) == 3);
    const CompareExchange second = compare_exchange_of(3, 2, 1, keys);
    CHECK(second.lower == 2);
    CHECK(second.upper == 3);
    CHECK(second.thread == 1);
    CHECK_FALSE(second.ascending);
    CHECK(second.swapped);
    CHECK_FALSE(compare_exchange_of(5, 2, 1, keys).swapped);
    CHECK(compare_exchange_of(6, 8, 4, keys).thread == 2);
}

TEST_CASE("a slot's table has a column a word, finds balls, and writes CSV", "[measure]") {
    const Built built(1.0);
    const auto bytes = std::as_bytes(std::span(built.keys));
    const Bytes keys(bytes.begin(), bytes.end());
    CHECK(element_count(Slot::keys, keys) == 64);
    const auto slot = element_of_ball(Slot::keys, keys, 17);
    REQUIRE(slot);
    CHECK(element_text(Slot::keys, keys, *slot, 1) == "17");
    CHECK_FALSE(element_of_ball(Slot::keys, keys, 41));
    CHECK_FALSE(element_of_ball(Slot::cell_ranges, keys, 1));
    std::ostringstream csv;
    write_slot_csv(csv, Slot::keys, std::span(keys).first(16));
    CHECK(csv.str() == "slot,cell_id,ball_id\n0," + std::to_string(built.keys[0].cell_id) + "," +
                           std::to_string(built.keys[0].ball_id) + "\n1," + std::to_string(built.keys[1].cell_id) +
                           "," + std::to_string(built.keys[1].ball_id) + "\n");
}
