// Does each check bite? Every comparer and every invariant gets a planted error and must name its place.
// (check_test.cpp does the same to the whole check.)
#include <cmath>
#include <limits>
#include <string>

#include "core/simulation.h"
#include "cpu/cpu_backend.h"
#include "measure/comparison.h"
#include "measure/invariants.h"
#include "measure/momentum.h"
#include "support/catch.h"
#include "support/scenes.h"
#include "support/substep_setup.h"

using namespace ballpit;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

// What a whole substep leaves on the mirror.
struct Substep {
    std::vector<Key> assigned, keys;
    std::vector<CellRange> ranges;
    std::vector<vec4> positions, velocities;
    std::uint32_t balls = 0;
    std::uint32_t cells = 0;
};

Substep good_substep(std::uint32_t balls = 100) {
    const BallState state = test::placed_balls(test::Placement::uniform, balls);
    const auto setup = test::setup_for(state, test::contact_features(), SortMethod::bitonic);
    cpu::CpuBackend<float> backend;
    backend.load(state, setup.schedule, true);
    Substep result;
    test::run_stage(backend, setup, Stage::assign_cells);
    result.assigned = read_slot<Key>(backend, Slot::keys);
    backend.run(setup.schedule, setup.params, 1, setup.schedule.dispatches.size());
    result.keys = read_slot<Key>(backend, Slot::keys);
    result.ranges = read_slot<CellRange>(backend, Slot::cell_ranges);
    result.positions = read_slot<vec4>(backend, Slot::next_positions);
    result.velocities = read_slot<vec4>(backend, Slot::next_velocities);
    result.balls = balls;
    result.cells = setup.schedule.cell_count;
    return result;
}

std::string text_of(const measure::Violation& violation) { return violation.value_or("none"); }

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string assigned(const Substep& s) { return text_of(measure::keys_assigned(s.assigned, s.balls, s.cells)); }
std::string sorted(const Substep& s) { return text_of(measure::keys_sorted(s.keys, s.balls)); }
std::string partitioned(const Substep& s) { return text_of(measure::ranges_partition(s.ranges, s.keys, s.balls)); }
std::string finite(const Substep& s) { return text_of(measure::all_finite(s.positions, s.velocities)); }

// The first cell with at least `balls` balls.
std::uint32_t occupied_cell(const Substep& s, std::uint32_t balls = 1) {
    for (std::uint32_t cell = 0; cell < s.ranges.size(); ++cell) {
        if (s.ranges[cell].end - s.ranges[cell].first >= balls) {
            return cell;
        }
    }
    FAIL("no cell is occupied");
    return 0;
}

template <class T>
measure::Comparison compare(Slot slot, const std::vector<T>& gpu, const std::vector<T>& cpu,
                            const std::vector<double>& bounds = {}) {
    return measure::compare_slot(slot, std::as_bytes(std::span(gpu)), std::as_bytes(std::span(cpu)), bounds);
}

}  // namespace

TEST_CASE("an untouched substep passes every check", "[sabotage]") {
    for (const std::uint32_t balls : {0u, 1u, 2u, 64u, 100u}) {
        const Substep s = balls == 0 ? Substep{} : good_substep(balls);
        CHECK(assigned(s) == "none");
        CHECK(sorted(s) == "none");
        CHECK(partitioned(s) == "none");
        CHECK(finite(s) == "none");
    }
}

TEST_CASE("keys_assigned names a wrong ball, a cell that is none, and a missing sentinel", "[sabotage]") {
    Substep s = good_substep();
    std::swap(s.assigned[7], s.assigned[8]);
    CHECK(contains(assigned(s), "key 7 "));
    s = good_substep();
    s.assigned[40].cell_id = s.cells;
    CHECK(contains(assigned(s), "key 40 "));
    s = good_substep();
    s.assigned[100] = {0, 100};
    CHECK(contains(assigned(s), "key 100 pads"));
}

TEST_CASE("keys_sorted names two keys exchanged, a ball lost and a ball twice", "[sabotage]") {
    Substep s = good_substep();
    std::swap(s.keys[30], s.keys[60]);
    CHECK(contains(sorted(s), "slot 31 holds"));
    s = good_substep();
    s.keys[50].ball_id = s.keys[49].ball_id;
    s.keys[50].cell_id = s.keys[49].cell_id;
    CHECK(contains(sorted(s), "slot 50 holds ball " + std::to_string(s.keys[49].ball_id) + " a second time"));
    s = good_substep();
    s.keys[99].ball_id = 100;
    CHECK(contains(sorted(s), "slot 99 holds ball 100, which does not exist"));
    s = good_substep();
    s.keys[99] = {SENTINEL, SENTINEL};
    CHECK(contains(sorted(s), "slot 99 "));
    s = good_substep();
    s.keys[100] = {SENTINEL - 1, 3};
    CHECK(contains(sorted(s), "slot 100 should hold a sentinel"));
    s = good_substep();
    s.keys.resize(90);
    CHECK(contains(sorted(s), "90 keys for 100 balls"));
}

TEST_CASE("the order of ball ids within a cell counts", "[sabotage]") {
    Substep s = good_substep(3000);
    const std::uint32_t cell = occupied_cell(s, 2);
    const std::uint32_t slot = s.ranges[cell].first;
    std::swap(s.keys[slot], s.keys[slot + 1]);
    CHECK(contains(sorted(s), "slot " + std::to_string(slot + 1) + " holds"));
}

TEST_CASE("ranges_partition names an end off by one, a cell shifted by one, and what is left of the past",
          "[sabotage]") {
    const auto cell_text = [](std::uint32_t cell) { return "cell " + std::to_string(cell) + " has slots"; };
    Substep s = good_substep();
    std::uint32_t cell = occupied_cell(s);
    s.ranges[cell].end += 1;
    CHECK(contains(partitioned(s), cell_text(cell)));
    s = good_substep();
    s.ranges[cell].first += 1;
    CHECK(contains(partitioned(s), cell_text(cell)));
    s = good_substep();
    s.ranges[cell] = {0, 0};  // the trap: `end` not written
    CHECK_FALSE(partitioned(s) == "none");
    s = good_substep();
    while (s.ranges[cell + 1].end != 0) {
        ++cell;
    }
    std::swap(s.ranges[cell], s.ranges[cell + 1]);
    CHECK(contains(partitioned(s), cell_text(cell + 1)));
    s = good_substep();
    s.ranges.back() = {3, 5};  // the trap: the table not cleared
    CHECK(contains(partitioned(s), cell_text(s.cells - 1)));
    s = good_substep();
    for (std::uint32_t last = s.cells; last-- > 0;) {
        if (s.ranges[last].end != 0) {
            s.ranges[last] = {0, 0};
            break;
        }
    }
    CHECK(contains(partitioned(s), "the ranges end at slot"));
}

TEST_CASE("all_finite names the ball that is no number", "[sabotage]") {
    for (const float bad :
         {not_a_number, std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()}) {
        for (int component = 0; component < 4; ++component) {
            Substep s = good_substep();
            s.positions[63][component] = bad;
            CHECK(contains(finite(s), "ball 63 "));
            s = good_substep();
            s.velocities[64][component] = bad;
            CHECK(contains(finite(s), "ball 64 "));
        }
    }
}

TEST_CASE("compare_slot finds one ulp, and says in which ball", "[sabotage]") {
    const Substep s = good_substep();
    CHECK(compare(Slot::next_positions, s.positions, s.positions).differing == 0);
    auto other = s.positions;
    other[17].y = std::nextafter(other[17].y, 10.0f);
    const auto strict = compare(Slot::next_positions, other, s.positions);
    CHECK(strict.elements == 100);
    CHECK(strict.differing == 1);
    CHECK(strict.beyond_bound == 1);
    CHECK(strict.max_ulp == 1);
    CHECK(strict.max_error > 0.0);
    CHECK(contains(strict.first, "ball 17: GPU ("));
    std::vector<double> bounds(100, 1e-3);
    CHECK(compare(Slot::next_positions, other, s.positions, bounds).beyond_bound == 0);
    CHECK(compare(Slot::next_positions, other, s.positions, bounds).differing == 1);
    bounds[17] = 1e-12;
    CHECK(compare(Slot::next_positions, other, s.positions, bounds).beyond_bound == 1);
}

TEST_CASE("compare_slot names the first element beyond its bound, not the first that differs", "[sabotage]") {
    const Substep s = good_substep();
    auto other = s.velocities;
    other[3].x = std::nextafter(other[3].x, 10.0f);
    other[71].z += 0.5f;
    const auto result = compare(Slot::next_velocities, other, s.velocities, std::vector<double>(100, 1e-3));
    CHECK(result.differing == 2);
    CHECK(result.beyond_bound == 1);
    CHECK(contains(result.first, "ball 71: "));
    CHECK(result.max_error == Approx(0.5).epsilon(1e-5));
}

TEST_CASE("compare_slot lets no NaN pass, whatever the bound", "[sabotage]") {
    const Substep s = good_substep();
    auto other = s.positions;
    other[5].x = not_a_number;
    const auto result = compare(Slot::next_positions, other, s.positions, std::vector<double>(100, 1e9));
    CHECK(result.beyond_bound == 1);
    CHECK(contains(result.first, "ball 5: "));
    CHECK(result.max_ulp == std::numeric_limits<std::uint64_t>::max());
    CHECK(std::isinf(result.max_error));
    // Nor a NaN hidden behind another float that differs less.
    other[5].y += 1e-6f;
    CHECK(compare(Slot::next_positions, other, s.positions, std::vector<double>(100, 1e9)).beyond_bound == 1);
    CHECK(compare(Slot::next_positions, other, other).differing == 0);
}

TEST_CASE("compare_slot finds keys exchanged, a range off by one, a status bit and a missing element", "[sabotage]") {
    const Substep s = good_substep();
    auto keys = s.keys;
    std::swap(keys[9], keys[10]);
    const auto exchanged = compare(Slot::keys, keys, s.keys);
    CHECK(exchanged.beyond_bound == 2);
    CHECK(contains(exchanged.first, "slot 9: "));
    auto ranges = s.ranges;
    ranges[1234].end += 1;
    CHECK(contains(compare(Slot::cell_ranges, ranges, s.ranges).first, "cell 1234: "));
    const std::vector<Status> clean{Status{}};
    std::vector<Status> dirty{Status{}};
    dirty.front().bits = STATUS_OUT_OF_BOUNDS;
    dirty.front().out_of_bounds = 1;
    CHECK(compare(Slot::status, dirty, clean).beyond_bound == 1);
    keys = s.keys;
    keys.pop_back();
    const auto missing = compare(Slot::keys, keys, s.keys);
    CHECK(missing.beyond_bound == 1);
    CHECK(contains(missing.first, "GPU has 127 elements, CPU 128"));
}

TEST_CASE("what is no number on both sides does not differ, on one side it does", "[sabotage]") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<vec4> ours{{nan, 1.0f, 2.0f, 3.0f}};
    const std::vector<vec4> same{{-nan, 1.0f, 2.0f, 3.0f}};
    const std::vector<vec4> other{{0.0f, 1.0f, 2.0f, 3.0f}};
    CHECK(compare(Slot::positions, ours, same).beyond_bound == 0);
    CHECK(compare(Slot::positions, ours, other).beyond_bound == 1);
    CHECK(compare(Slot::positions, other, ours).beyond_bound == 1);
    CHECK(measure::ulp_distance(nan, -nan) == 0);
    CHECK(measure::ulp_distance(nan, 1.0f) == UINT64_MAX);
}

TEST_CASE("ulp_distance counts floats", "[sabotage]") {
    CHECK(measure::ulp_distance(1.0f, 1.0f) == 0);
    CHECK(measure::ulp_distance(1.0f, std::nextafter(1.0f, 2.0f)) == 1);
    CHECK(measure::ulp_distance(0.0f, -0.0f) == 0);
    CHECK(measure::ulp_distance(std::nextafter(0.0f, 1.0f), std::nextafter(0.0f, -1.0f)) == 2);
    CHECK(measure::ulp_distance(1.0f, 2.0f) == 1u << 23);
    CHECK(measure::ulp_distance(not_a_number, 1.0f) == std::numeric_limits<std::uint64_t>::max());
    CHECK(measure::ulp_distance(not_a_number, not_a_number) == 0);
}

TEST_CASE("momentum_balanced finds a ball that was pushed by nothing", "[sabotage]") {
    const Scene scene = test::shipped_scene("pile");
    Settings settings = scene.settings;
    settings.balls = 200;
    Simulation simulation(scene, settings, 42, std::make_unique<cpu::CpuBackend<float>>());
    for (int i = 0; i < 60; ++i) {
        simulation.step();
    }
    Backend& backend = simulation.backend();
    backend.run(simulation.schedule(), simulation.params(), 0, simulation.schedule().dispatches.size());
    const auto positions = read_slot<vec4>(backend, Slot::positions);
    const auto velocities = read_slot<vec4>(backend, Slot::velocities);
    auto next = read_slot<vec4>(backend, Slot::next_velocities);
    const auto balance = [&] {
        return measure::momentum_balanced(simulation.params(), simulation.features(), positions, velocities, {}, next);
    };
    CHECK_FALSE(balance());
    next[17].z += 0.01f;
    CHECK(balance());
    next[17].z -= 0.01f;
    next[3].x *= -1.0f;
    next[3].x += 0.5f;
    CHECK(balance());
}
