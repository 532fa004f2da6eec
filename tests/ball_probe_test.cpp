// What the views of the grid and of one ball say, against what the stages do.
#include <algorithm>
#include <cmath>

#include "cpu/cpu_backend.h"
#include "measure/ball_probe.h"
#include "measure/cell_table.h"
#include "measure/neighbours.h"
#include "support/balls.h"
#include "support/catch.h"
#include "support/substep_setup.h"

using namespace ballpit;

namespace {

measure::BufferSample sample_of(test::Placement placement, std::uint32_t balls, double cell_factor = 1.0,
                                bool brute_force = false) {
    const BallState state = test::placed_balls(placement, balls);
    float r_max = 0.0f;
    for (const vec4& position : state.positions) {
        r_max = std::max(r_max, position.w);
    }
    const dvec3 half_extent(test::box_half_extent);
    const Grid grid = make_grid(half_extent, static_cast<double>(r_max), cell_factor, balls);
    Features features;
    features.add(Feature::contact);
    features.add(Feature::brute_force, brute_force);
    features.add(Feature::unequal_radii);
    features.add(Feature::unequal_masses);
    const Schedule schedule = make_schedule(balls, grid, features, SortMethod::bitonic);
    cpu::CpuBackend<float> backend;
    backend.load(state, schedule, true);
    Settings settings;
    const auto motion = substep_motion(settings.integrator, 0.0, 1.0 / 480.0, 0.0);
    backend.run(schedule, make_substep_params(settings, half_extent, grid, motion, balls), 0,
                schedule.dispatches.size());
    measure::BufferSample sample;
    sample.positions = read_slot<vec4>(backend, Slot::positions);
    sample.velocities = read_slot<vec4>(backend, Slot::velocities);
    sample.keys = read_slot<Key>(backend, Slot::keys);
    sample.cell_ranges = read_slot<CellRange>(backend, Slot::cell_ranges);
    sample.next_positions = read_slot<vec4>(backend, Slot::next_positions);
    sample.next_velocities = read_slot<vec4>(backend, Slot::next_velocities);
    sample.grid = grid;
    sample.uses_grid = !brute_force;
    return sample;
}

measure::GridView view_of(const measure::BufferSample& sample) {
    return {sample.positions, sample.keys, sample.cell_ranges, sample.grid};
}

}  // namespace

TEST_CASE("a ball's way through the buffers is the one collide takes", "[measure]") {
    for (const test::Placement placement : test::placements) {
        INFO(test::placement_names[static_cast<std::size_t>(placement)]);
        const measure::BufferSample sample = sample_of(placement, 500);
        for (const std::uint32_t ball : {0u, 73u, 499u}) {
            const measure::BallProbe probe = measure::probe_ball(sample, ball);
            const measure::BallTrace trace = measure::trace_ball(view_of(sample), ball);
            CHECK(probe.cell_id == trace.cell_id);
            CHECK(probe.slot == trace.slot);
            CHECK(probe.cells == trace.cells);
            CHECK(probe.tested == trace.tested.size());
            CHECK(probe.touched == trace.touched.size());
            std::vector<std::uint32_t> met;
            for (const measure::NeighbourRow& row : probe.rows) {
                met.push_back(row.ball);
                CHECK(sample.keys[row.slot.value()].ball_id == row.ball);
                CHECK(row.touches == measure::touching(sample.positions[ball], sample.positions[row.ball]));
            }
            CHECK(met == trace.tested);
            std::uint64_t in_runs = 0;
            for (const CellRange& run : probe.runs) {
                in_runs += run.end - run.first;
            }
            CHECK(in_runs == probe.tested + 1);
            REQUIRE(probe.velocity_change);
            CHECK(*probe.velocity_change == vec3(sample.next_velocities[ball]) - vec3(sample.velocities[ball]));
        }
    }
}

TEST_CASE("in the middle of a substep the way ends where the dispatches have got to", "[measure]") {
    measure::BufferSample sample = sample_of(test::Placement::uniform, 100);
    sample.next_positions.clear();
    sample.next_velocities.clear();
    CHECK_FALSE(measure::probe_ball(sample, 7).velocity_change);
    CHECK(&sample.shown() == &sample.positions);
    sample.cell_ranges.clear();
    const measure::BallProbe sorted = measure::probe_ball(sample, 7);
    CHECK(sorted.slot);
    CHECK(sorted.cells.empty());
    CHECK(sorted.tested == 0);
    CHECK(measure::found_pairs(sample).missed.empty());
    sample.keys.clear();
    const measure::BallProbe fresh = measure::probe_ball(sample, 7);
    CHECK_FALSE(fresh.cell_id);
    CHECK_FALSE(fresh.slot);
    CHECK(fresh.position == sample.positions[7]);
}

TEST_CASE("keys and ranges that point nowhere are left out, not followed", "[measure]") {
    measure::BufferSample sample = sample_of(test::Placement::one_cell, 40);
    const std::uint32_t cell = sample.keys[0].cell_id;
    sample.cell_ranges[cell] = {0, 4000000000u};
    sample.keys[3].ball_id = 123456;
    const measure::BallProbe probe = measure::probe_ball(sample, sample.keys[0].ball_id);
    CHECK(probe.tested == 38);  // 40 less itself and the one that is no ball
    for (const std::uint32_t ball : measure::balls_of_cell(sample, cell)) {
        CHECK((ball < 40 || ball == 123456 || ball == SENTINEL));
    }
    CHECK(measure::balls_of_cell(sample, 4000000000u).empty());
}

TEST_CASE("brute force asks everyone and misses nobody, small cells miss pairs", "[measure]") {
    const measure::BufferSample everyone = sample_of(test::Placement::uniform, 2000, 1.0, true);
    const measure::FoundPairs all = measure::found_pairs(everyone);
    CHECK(all.tested == 2000u * 1999u);
    CHECK(all.missed.empty());
    CHECK(measure::probe_ball(everyone, 5).tested == 1999);
    CHECK_FALSE(measure::probe_ball(everyone, 5).cell_id);

    for (const double factor : {1.0, 1.5, 4.0}) {
        const measure::FoundPairs grid = measure::found_pairs(sample_of(test::Placement::uniform, 2000, factor));
        CHECK(grid.missed.empty());
        CHECK(grid.found == all.found);
        CHECK(grid.tested < all.tested);
    }
    const measure::BufferSample narrow = sample_of(test::Placement::uniform, 2000, 0.5);
    const measure::FoundPairs few = measure::found_pairs(narrow);
    const measure::NeighbourReport report = measure::neighbour_report(view_of(narrow));
    CHECK_FALSE(few.missed.empty());
    CHECK(few.missed == report.missed);
    CHECK(few.found.size() == report.contacts);
    CHECK(few.tested == report.tested);
    CHECK(few.found.size() + few.missed.size() == all.found.size());
}

TEST_CASE("a number a ball: slot, contacts, radius", "[measure]") {
    const measure::BufferSample sample = sample_of(test::Placement::radii_1_to_4, 300);
    const std::vector<float> slots = measure::slot_values(sample);
    for (std::uint32_t ball = 0; ball < 300; ++ball) {
        CHECK(sample.keys[static_cast<std::size_t>(slots[ball])].ball_id == ball);
    }
    const measure::FoundPairs pairs = measure::found_pairs(sample);
    const std::vector<float> contacts = measure::contact_values(pairs, 300);
    for (const std::uint32_t ball : {0u, 150u, 299u}) {
        CHECK(contacts[ball] == static_cast<float>(measure::probe_ball(sample, ball).touched));
    }
    CHECK(measure::radius_values(sample)[8] == sample.positions[8].w);
    measure::BufferSample unsorted = sample;
    unsorted.keys.clear();
    CHECK(std::isnan(measure::slot_values(unsorted)[0]));
}

TEST_CASE("cells are listed in any order, equal ones by their ids", "[measure]") {
    const measure::BufferSample sample = sample_of(test::Placement::uniform, 3000);
    using measure::CellColumn;
    for (const CellColumn column : {CellColumn::cell, CellColumn::x, CellColumn::y, CellColumn::z, CellColumn::first,
                                    CellColumn::end, CellColumn::balls}) {
        for (const bool descending : {false, true}) {
            for (const bool only_occupied : {false, true}) {
                const auto cells =
                    measure::ordered_cells(sample.grid, sample.cell_ranges, {column, descending, only_occupied});
                const auto balls = [&](std::uint32_t cell) {
                    return sample.cell_ranges[cell].end - sample.cell_ranges[cell].first;
                };
                const auto value = [&](std::uint32_t cell) -> std::uint32_t {
                    const uvec3 place = measure::cell_of_id(sample.grid, cell);
                    switch (column) {
                        case CellColumn::cell:
                            return cell;
                        case CellColumn::x:
                            return place.x;
                        case CellColumn::y:
                            return place.y;
                        case CellColumn::z:
                            return place.z;
                        case CellColumn::first:
                            return sample.cell_ranges[cell].first;
                        case CellColumn::end:
                            return sample.cell_ranges[cell].end;
                        case CellColumn::balls:
                            return balls(cell);
                    }
                    return 0;
                };
                const bool in_order = std::ranges::is_sorted(cells, [&](std::uint32_t a, std::uint32_t b) {
                    if (value(a) == value(b)) {
                        return a < b;
                    }
                    return descending ? value(a) > value(b) : value(a) < value(b);
                });
                CHECK(in_order);
                const auto occupied = static_cast<std::size_t>(
                    std::ranges::count_if(cells, [&](std::uint32_t cell) { return balls(cell) > 0; }));
                CHECK(cells.size() == (only_occupied ? occupied : sample.cell_ranges.size()));
                CHECK(measure::row_of_cell(cells, cells.back()) == cells.size() - 1);
            }
        }
    }
    CHECK(measure::ordered_cells(sample.grid, {}, {}).empty());
    CHECK_FALSE(measure::row_of_cell({}, 3));
}

TEST_CASE("a broken table of cells is shown as it is", "[measure]") {
    Grid grid;
    grid.cells = {2, 1, 1};
    const std::vector<CellRange> ranges = {{7, 4294967295u}, {0, 3}};
    const auto cells = measure::ordered_cells(grid, ranges, {measure::CellColumn::end, false, true});
    CHECK(cells == std::vector<std::uint32_t>{1, 0});
}

TEST_CASE("a difference is a length, whatever the fourth component", "[measure]") {
    const std::vector<vec4> a = {{0, 0, 0, 1}, {1, 2, 3, 4}};
    const std::vector<vec4> b = {{3, 4, 0, 9}, {1, 2, 3, 5}};
    CHECK(measure::difference_values(a, b) == std::vector<float>{5.0f, 0.0f});
}

TEST_CASE("a ball that is followed leads to the next one in quarantine, around the end", "[measure]") {
    measure::BufferSample sample;
    sample.uses_grid = false;
    sample.positions.assign(6, vec4(0.0f, 0.0f, 0.0f, 0.1f));
    CHECK_FALSE(measure::probe_ball(sample, 3).next_quarantined);
    sample.positions[1].w = -0.1f;
    for (const std::uint32_t ball : {0u, 1u, 5u}) {
        CHECK(measure::probe_ball(sample, ball).next_quarantined == 1u);
    }
    sample.positions[4].w = -0.1f;
    CHECK(measure::probe_ball(sample, 1).next_quarantined == 4u);
    CHECK(measure::probe_ball(sample, 4).next_quarantined == 1u);
}
