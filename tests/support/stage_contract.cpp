#include "support/stage_contract.h"

#include <bit>
#include <cmath>
#include <string>

#include "core/layout.h"
#include "cpu/assign_cells.h"
#include "measure/invariants.h"
#include "measure/pairs.h"
#include "support/catch.h"
#include "support/substep_setup.h"

namespace ballpit::test {

namespace {

constexpr std::array sorts = {SortMethod::bitonic, SortMethod::bitonic_fused, SortMethod::counting};

std::string text_of(const measure::Violation& violation) { return violation.value_or("none"); }

std::uint32_t id_of(const uvec3& cell, const uvec3& cells) { return (cell.z * cells.y + cell.y) * cells.x + cell.x; }

// Cell ids for `count` balls in ways that sorts get wrong.
enum class Pattern { random, few_cells, all_equal, ascending, descending, alternating };
constexpr std::array patterns = {Pattern::random,    Pattern::few_cells,  Pattern::all_equal,
                                 Pattern::ascending, Pattern::descending, Pattern::alternating};

std::uint32_t cell_in(Pattern pattern, std::uint32_t i, std::uint32_t count) {
    switch (pattern) {
        case Pattern::random:
            return static_cast<std::uint32_t>(random_unit(3, 0, i) * 4096.0);
        case Pattern::few_cells:
            return static_cast<std::uint32_t>(random_unit(4, 0, i) * 3.0);
        case Pattern::all_equal:
            return 7;
        case Pattern::ascending:
            return i % 4096;
        case Pattern::descending:
            return (count - i) % 4096;
        case Pattern::alternating:
            return i % 2 == 0 ? 4095 : 0;
    }
    return 0;
}

std::vector<Key> keys_in(Pattern pattern, std::uint32_t count) {
    std::vector<Key> keys(count == 0 ? 0 : std::bit_ceil(count), Key{SENTINEL, SENTINEL});
    for (std::uint32_t i = 0; i < count; ++i) {
        keys[i] = {cell_in(pattern, i, count), i};
    }
    return keys;
}

void sort_keys(std::vector<Key>& keys) {
    std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) { return a < b; });
}

// The ranges, by counting: independent of neighbours in the order.
std::vector<CellRange> counted_ranges(const std::vector<Key>& sorted, std::uint32_t count, std::size_t cells) {
    std::vector<std::uint32_t> balls(cells, 0);
    for (std::uint32_t slot = 0; slot < count; ++slot) {
        ++balls[sorted[slot].cell_id];
    }
    std::vector<CellRange> ranges(cells, CellRange{0, 0});
    std::uint32_t next = 0;
    for (std::size_t cell = 0; cell < cells; ++cell) {
        if (balls[cell] > 0) {
            ranges[cell] = {next, next + balls[cell]};
            next += balls[cell];
        }
    }
    return ranges;
}

template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const T& x, const T& y) { return x == y; });
}

// The pairs that a walk over 3 x 3 x 3 cells of the backend's own table meets.
std::vector<measure::Pair> pairs_of_grid(Backend& backend, const SubstepSetup& setup) {
    const auto params = narrowed<float>(setup.params);
    const auto positions = read_slot<vec4>(backend, Slot::positions);
    const auto keys = read_slot<Key>(backend, Slot::keys);
    const auto ranges = read_slot<CellRange>(backend, Slot::cell_ranges);
    std::vector<measure::Pair> pairs;
    for (std::uint32_t a = 0; a < positions.size(); ++a) {
        const uvec3 middle = cpu::cell_coordinates(params, vec3(positions[a]));
        for (std::uint32_t offset = 0; offset < 27; ++offset) {
            const uvec3 cell = middle + uvec3(offset % 3, offset / 3 % 3, offset / 9) - 1u;  // wraps below 0
            if (glm::any(glm::greaterThanEqual(cell, params.grid_cells))) {
                continue;
            }
            const CellRange& range = ranges[id_of(cell, params.grid_cells)];
            for (std::uint32_t slot = range.first; slot < range.end; ++slot) {
                const std::uint32_t b = keys[slot].ball_id;
                if (a < b && measure::touching(positions[a], positions[b])) {
                    pairs.push_back({a, b});
                }
            }
        }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

}  // namespace

std::vector<std::uint32_t> interesting_counts(std::uint32_t largest) {
    std::vector<std::uint32_t> counts;
    for (std::uint32_t n = 0; n <= std::min<std::uint32_t>(largest, 2 * GROUP_SIZE); ++n) {
        counts.push_back(n);
    }
    for (const std::uint32_t n : {255u, 256u, 257u, 511u, 512u, 513u, 1023u, 1024u, 1025u, 2047u, 2048u, 2049u, 4095u,
                                  4096u, 4097u, 5000u, 65535u, 65536u, 65537u}) {
        if (n <= largest) {
            counts.push_back(n);
        }
    }
    return counts;
}

void assigns_cells(Backend& backend, std::span<const std::uint32_t> counts) {
    for (const Placement placement : placements) {
        for (const std::uint32_t count : counts) {
            const BallState state = placed_balls(placement, count);
            const SubstepSetup setup = setup_for(state, contact_features(), SortMethod::bitonic);
            backend.load(state, setup.schedule, true);
            write_slot(backend, Slot::keys, std::vector<Key>(setup.schedule.key_count, Key{3, 5}));  // of the past
            run_stage(backend, setup, Stage::assign_cells);
            const auto keys = read_slot<Key>(backend, Slot::keys);
            CAPTURE(count, placement_names[static_cast<std::size_t>(placement)]);
            REQUIRE(keys.size() == setup.schedule.key_count);
            REQUIRE(text_of(measure::keys_assigned(keys, count, setup.schedule.cell_count)) == "none");
            const Grid& grid = setup.schedule.grid;
            std::uint32_t outside = 0;
            for (std::uint32_t i = 0; i < count; ++i) {
                uvec3 cell;
                for (int axis = 0; axis < 3; ++axis) {
                    // In double, which is exact here: the box and the cells are dyadic.
                    const double along =
                        (static_cast<double>(state.positions[i][axis]) - grid.origin[axis]) / grid.cell_width;
                    cell[axis] = static_cast<std::uint32_t>(std::clamp(std::floor(along), 0.0, grid.cells[axis] - 1.0));
                }
                // Next to a face, float may round onto it.
                const std::uint32_t id = id_of(cell, grid.cells);
                if (placement != Placement::on_faces) {
                    REQUIRE(keys[i].cell_id == id);
                } else {
                    const auto exact = narrowed<float>(setup.params);
                    REQUIRE(keys[i].cell_id ==
                            id_of(cpu::cell_coordinates(exact, vec3(state.positions[i])), grid.cells));
                }
                outside +=
                    glm::any(glm::greaterThan(glm::abs(vec3(state.positions[i])), vec3(box_half_extent))) ? 1 : 0;
            }
            REQUIRE((count == 0 || status_of(backend).out_of_bounds == outside));
            REQUIRE((count == 0 || (status_of(backend).bits != 0) == (outside != 0)));
        }
    }
}

void assigns_strange_points(Backend& backend) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    constexpr float r = usual_radius;
    // Faces are at multiples of 0.25; 16 cells an axis.
    const std::array<std::pair<vec3, uvec3>, 11> points = {{{{-2, -2, -2}, {0, 0, 0}},
                                                            {{2, 2, 2}, {15, 15, 15}},
                                                            {{0, 0, 0}, {8, 8, 8}},
                                                            {{0.25f, -0.25f, 1.75f}, {9, 7, 15}},
                                                            {{-3, 0, 1e30f}, {0, 8, 15}},
                                                            {{-infinity, infinity, 0}, {0, 15, 8}},
                                                            {{nan, 0, 0}, {0, 8, 8}},
                                                            {{0, nan, nan}, {8, 0, 0}},
                                                            {{-0.0f, 0.0f, -1e-30f}, {8, 8, 8}},
                                                            {{1e38f, -1e38f, -2.0001f}, {15, 0, 0}},
                                                            {{1.999999f, -1.999999f, 0.249999f}, {15, 0, 8}}}};
    BallState state;
    for (const auto& point : points) {
        state.positions.emplace_back(point.first, r);
        state.velocities.emplace_back(0, 0, 0, 1);
    }
    const SubstepSetup setup = setup_for(state, contact_features(), SortMethod::bitonic);
    REQUIRE(setup.schedule.grid.cells == uvec3(16));
    backend.load(state, setup.schedule, true);
    run_stage(backend, setup, Stage::assign_cells);
    const auto keys = read_slot<Key>(backend, Slot::keys);
    for (std::size_t i = 0; i < points.size(); ++i) {
        CAPTURE(i);  // 8: -1e-30 - (-2) is 2 in float, which lies in the cell above
        CHECK(keys[i].cell_id == id_of(points[i].second, uvec3(16)));
    }
    CHECK(status_of(backend).out_of_bounds == 3);  // NaN is not outside: collide reports it
}

void sorts_every_pattern(Backend& backend, SortMethod sort, std::span<const std::uint32_t> counts) {
    for (const std::uint32_t count : counts) {
        const BallState state = placed_balls(Placement::uniform, count);
        const SubstepSetup setup = setup_for(state, contact_features(), sort);
        backend.load(state, setup.schedule, true);
        for (const Pattern pattern : patterns) {
            CAPTURE(count, static_cast<int>(pattern));
            auto keys = keys_in(pattern, count);
            write_slot(backend, Slot::keys, keys);
            run_stage(backend, setup, Stage::bitonic_sort);
            const auto sorted = read_slot<Key>(backend, Slot::keys);
            sort_keys(keys);
            REQUIRE(same(sorted, keys));
            REQUIRE(text_of(measure::keys_sorted(sorted, count)) == "none");
        }
    }
}

void counts_and_sorts_every_pattern(Backend& backend, std::span<const std::uint32_t> counts) {
    for (const std::uint32_t count : counts) {
        const BallState state = placed_balls(Placement::uniform, count);
        const SubstepSetup setup = setup_for(state, contact_features(), SortMethod::counting);
        backend.load(state, setup.schedule, true);
        // One after the other on the same table: what is left of the one before must not show.
        for (const Pattern pattern : patterns) {
            CAPTURE(count, static_cast<int>(pattern));
            auto keys = keys_in(pattern, count);
            write_slot(backend, Slot::keys, keys);
            run_stage(backend, setup, Stage::build_grid);
            sort_keys(keys);
            const auto ranges = read_slot<CellRange>(backend, Slot::cell_ranges);
            REQUIRE(same(ranges, counted_ranges(keys, count, setup.schedule.cell_count)));
            run_stage(backend, setup, Stage::counting_sort);
            const auto sorted = read_slot<Key>(backend, Slot::keys);
            REQUIRE(same(sorted, keys));
            REQUIRE(text_of(measure::keys_sorted(sorted, count)) == "none");
        }
    }
}

void builds_the_grid(Backend& backend, std::span<const std::uint32_t> counts) {
    for (const std::uint32_t count : counts) {
        const BallState state = placed_balls(Placement::uniform, count);
        const SubstepSetup setup = setup_for(state, contact_features(), SortMethod::bitonic);
        REQUIRE((count == 0 || setup.schedule.cell_count == 4096));
        backend.load(state, setup.schedule, true);
        // One after the other on the same table: what is left of the one before must not show.
        for (const Pattern pattern : patterns) {
            CAPTURE(count, static_cast<int>(pattern));
            auto keys = keys_in(pattern, count);
            sort_keys(keys);
            write_slot(backend, Slot::keys, keys);
            run_stage(backend, setup, Stage::build_grid);
            const auto ranges = read_slot<CellRange>(backend, Slot::cell_ranges);
            REQUIRE(same(ranges, counted_ranges(keys, count, setup.schedule.cell_count)));
            REQUIRE(text_of(measure::ranges_partition(ranges, keys, count)) == "none");
        }
    }
}

void refuses_keys_of_no_cell(Backend& backend) {
    const BallState state = placed_balls(Placement::uniform, 3);
    const SubstepSetup setup = setup_for(state, contact_features(), SortMethod::bitonic);
    backend.load(state, setup.schedule, true);
    write_slot(backend, Slot::keys, std::vector<Key>{{5, 0}, {4096, 1}, {0xFFFFFFFE, 2}, {SENTINEL, SENTINEL}});
    run_stage(backend, setup, Stage::build_grid);
    const Status status = status_of(backend);
    CHECK(status.bits == STATUS_OVER_CAPACITY);
    CHECK(status.over_capacity == 2);
    CHECK((read_slot<CellRange>(backend, Slot::cell_ranges)[5] == CellRange{0, 1}));
}

void finds_every_pair(Backend& backend, std::span<const std::uint32_t> counts) {
    for (const Placement placement : placements) {
        for (const std::uint32_t count : counts) {
            const BallState state = placed_balls(placement, count);
            const auto expected = measure::brute_force_pairs(state.positions);
            const double r_max = static_cast<double>(usual_radius);
            for (const Grid& grid : {dyadic_grid(), make_grid(dvec3(box_half_extent), r_max, 1.0, count)}) {
                for (const SortMethod sort : sorts) {
                    const SubstepSetup setup = setup_for(state, contact_features(), sort, {}, grid);
                    run_all(backend, state, setup);
                    CAPTURE(count, placement_names[static_cast<std::size_t>(placement)]);
                    REQUIRE((pairs_of_grid(backend, setup) == expected));
                }
            }
        }
    }
}

}  // namespace ballpit::test
