#include "core/schedule.h"

#include <algorithm>
#include <bit>
#include <cassert>

namespace ballpit {

namespace {

bool needs_grid(Features features) { return features.has(Feature::contact) && !features.has(Feature::brute_force); }

// Features that each shader looks at; the others must not split its permutations.
Features relevant(Shader shader, Features features) {
    Features seen;
    switch (shader) {
        case Shader::collide:
            return features;
        case Shader::assign_cells:
        case Shader::build_grid:
        case Shader::count_cells:
            seen.add(Feature::diagnostics, features.has(Feature::diagnostics));
            break;
        case Shader::count_missed:
            seen.add(Feature::diagnostics, features.has(Feature::diagnostics));
            seen.add(Feature::unequal_radii, features.has(Feature::unequal_radii));
            break;
        case Shader::bitonic_sort:
        case Shader::bitonic_sort_fused:
        case Shader::bitonic_sort_strides:
        case Shader::clear_cells:
        case Shader::count_tiles:
        case Shader::scan_cells:
        case Shader::scatter_keys:
        case Shader::order_keys:
        case Shader::keep_places:
        case Shader::gather:
            break;
    }
    return seen;
}

struct Builder {
    Schedule& schedule;

    // A stage that counts failures does so in the status word.
    void add_diagnosed(Stage stage, std::string name, Shader shader, Groups groups, std::vector<Slot> reads,
                       std::vector<Slot> writes) const {
        if (schedule.features.has(Feature::diagnostics)) {
            reads.push_back(Slot::status);
            writes.push_back(Slot::status);
        }
        add(stage, std::move(name), shader, groups, {}, std::move(reads), std::move(writes));
    }

    void add(Stage stage, std::string name, Shader shader, Groups groups, std::array<std::uint32_t, 4> constants,
             std::vector<Slot> reads, std::vector<Slot> writes) const {
        schedule.dispatches.push_back({stage,
                                       std::move(name),
                                       {shader, relevant(shader, schedule.features)},
                                       groups,
                                       constants,
                                       std::move(reads),
                                       std::move(writes)});
    }

    void pass(std::uint32_t k, std::uint32_t j) const {
        add(Stage::bitonic_sort, "bitonic_sort k=" + std::to_string(k) + " j=" + std::to_string(j),
            Shader::bitonic_sort, groups_for(schedule.key_count / 2, GROUP_SIZE), {k, j, 0, 0}, {Slot::keys},
            {Slot::keys});
    }

    // Up to three passes from j on, of which none stays inside a tile.
    void strides(std::uint32_t k, std::uint32_t j, std::uint32_t passes) const {
        add(Stage::bitonic_sort,
            "bitonic_sort_strides k=" + std::to_string(k) + " j=" + std::to_string(j) + ".." +
                std::to_string(j >> (passes - 1)),
            Shader::bitonic_sort_strides, groups_for(schedule.key_count / STRIDE_KEYS, GROUP_SIZE), {k, j, passes, 0},
            {Slot::keys}, {Slot::keys});
    }

    // The passes of k whose pairs reach beyond a tile, by threes where there are slots enough.
    void passes_beyond(std::uint32_t k, std::uint32_t tile) const {
        for (std::uint32_t j = k / 2; j >= tile;) {
            const auto left = static_cast<std::uint32_t>(std::countr_zero(j) - std::countr_zero(tile)) + 1;
            const std::uint32_t together = std::min(left, 3u);
            if (together > 1 && schedule.key_count >= STRIDE_KEYS * (j >> (together - 1))) {
                strides(k, j, together);
                j >>= together;
            } else {
                pass(k, j);
                j /= 2;
            }
        }
    }

    // All passes with k_first <= k <= k_last and j <= j_first that stay inside a tile.
    void fused(std::uint32_t k_first, std::uint32_t k_last, std::uint32_t j_first) const {
        const std::string name =
            k_first == k_last
                ? "bitonic_sort_fused k=" + std::to_string(k_first) + " j=" + std::to_string(j_first) + "..1"
                : "bitonic_sort_fused k=" + std::to_string(k_first) + ".." + std::to_string(k_last);
        const std::uint32_t tile = sort_tile_size(schedule.key_count);
        const std::uint32_t tiles = std::max(1u, schedule.key_count / tile);
        add(Stage::bitonic_sort, name, Shader::bitonic_sort_fused, groups_for(tiles, 1),
            {k_first, k_last, j_first, tile}, {Slot::keys}, {Slot::keys});
        schedule.dispatches.back().program.features.add(Feature::small_tiles, tile == SORT_SMALL_TILE_SIZE);
    }

    void sort_pass_by_pass() const {
        for (std::uint32_t k = 2; k <= schedule.key_count && k != 0; k *= 2) {
            for (std::uint32_t j = k / 2; j > 0; j /= 2) {
                pass(k, j);
            }
        }
    }

    void sort_fused() const {
        if (schedule.key_count < 2) {
            return;
        }
        const std::uint32_t tile = std::min(sort_tile_size(schedule.key_count), schedule.key_count);
        fused(2, tile, 1);
        for (std::uint32_t k = 2 * tile; k <= schedule.key_count && k != 0; k *= 2) {
            passes_beyond(k, tile);
            fused(k, k, tile / 2);
        }
    }

    void clear_cells() const {
        add(Stage::build_grid, "clear_cells", Shader::clear_cells, groups_for(tile_count(schedule.cell_count), 1), {},
            {Slot::used_tiles}, {Slot::cell_ranges, Slot::used_tiles});
    }

    // From the sorted keys to the ranges.
    void sort_then_build(SortMethod sort) const {
        sort == SortMethod::bitonic ? sort_pass_by_pass() : sort_fused();
        clear_cells();
        add_diagnosed(Stage::build_grid, "build_grid", Shader::build_grid, groups_for(schedule.ball_count, GROUP_SIZE),
                      {Slot::keys, Slot::used_tiles}, {Slot::cell_ranges, Slot::used_tiles});
    }

    // From the ranges to the sorted keys.
    void build_then_sort() const {
        const Groups balls = groups_for(schedule.ball_count, GROUP_SIZE);
        const Groups tiles = groups_for(tile_count(schedule.cell_count), 1);
        clear_cells();
        add_diagnosed(Stage::build_grid, "count_cells", Shader::count_cells, balls,
                      {Slot::keys, Slot::cell_ranges, Slot::used_tiles},
                      {Slot::cell_ranges, Slot::used_tiles, Slot::tickets});
        add(Stage::build_grid, "count_tiles", Shader::count_tiles, tiles, {}, {Slot::cell_ranges, Slot::used_tiles},
            {Slot::tile_counts});
        add(Stage::build_grid, "scan_cells", Shader::scan_cells, tiles, {},
            {Slot::cell_ranges, Slot::used_tiles, Slot::tile_counts}, {Slot::cell_ranges});
        add(Stage::counting_sort, "scatter_keys", Shader::scatter_keys, balls, {},
            {Slot::keys, Slot::cell_ranges, Slot::tickets}, {Slot::scattered_keys});
        add(Stage::counting_sort, "order_keys", Shader::order_keys, balls, {},
            {Slot::cell_ranges, Slot::scattered_keys}, {Slot::keys});
    }

    void build_neighbour_grid(SortMethod sort) const {
        add_diagnosed(Stage::assign_cells, "assign_cells", Shader::assign_cells,
                      groups_for(schedule.key_count, GROUP_SIZE), {Slot::positions}, {Slot::keys});
        schedule.counts_cells ? build_then_sort() : sort_then_build(sort);
    }

    // Both ask or tell where balls were when a grid was built: before the first look, then for the next one.
    void count_missed() const {
        const Groups groups = groups_for(schedule.ball_count, GROUP_SIZE);
        add_diagnosed(Stage::build_grid, "count_missed", Shader::count_missed, groups,
                      {Slot::positions, Slot::keys, Slot::cell_ranges, Slot::built_positions}, {});
        add(Stage::build_grid, "keep_places", Shader::keep_places, groups, {}, {Slot::positions},
            {Slot::built_positions});
    }

    void collide() const {
        const bool copies = schedule.features.has(Feature::sorted_copies);
        if (copies) {
            add(Stage::collide, "gather", Shader::gather, groups_for(schedule.ball_count, GROUP_SIZE), {},
                {Slot::positions, Slot::velocities, Slot::keys}, {Slot::sorted_positions, Slot::sorted_velocities});
        }
        std::vector<Slot> reads = copies ? std::vector{Slot::sorted_positions, Slot::sorted_velocities}
                                         : std::vector{Slot::positions, Slot::velocities};
        if (needs_grid(schedule.features)) {
            reads.insert(reads.end(), {Slot::keys, Slot::cell_ranges});
        }
        if (schedule.features.has(Feature::ball_restitution)) {
            reads.push_back(Slot::damping_ratios);
        }
        std::vector<Slot> writes = schedule.in_place ? std::vector{Slot::positions, Slot::velocities}
                                                     : std::vector{Slot::next_positions, Slot::next_velocities};
        if (schedule.features.has(Feature::compensated)) {  // in place: no other ball looks at them
            reads.push_back(Slot::compensations);
            writes.push_back(Slot::compensations);
        }
        add_diagnosed(Stage::collide, "collide", Shader::collide, groups_for(schedule.ball_count, GROUP_SIZE),
                      std::move(reads), std::move(writes));
    }
};

}  // namespace

Groups groups_for(std::uint32_t invocations, std::uint32_t group_size) {
    const std::uint32_t groups = invocations / group_size + (invocations % group_size != 0 ? 1 : 0);
    if (groups <= widest_dispatch) {
        return {groups, 1};
    }
    return {FOLDED_WIDTH, (groups + FOLDED_WIDTH - 1) / FOLDED_WIDTH};
}

std::uint32_t sort_tile_size(std::uint32_t key_count) {
    return key_count <= SORT_SMALL_KEYS ? SORT_SMALL_TILE_SIZE : SORT_TILE_SIZE;
}

std::uint32_t tile_count(std::uint32_t cell_count) { return (cell_count + TILE_CELLS - 1) / TILE_CELLS; }

std::uint32_t binding_of(Shader shader, Slot slot) {
    const bool collides = shader == Shader::collide;
    switch (slot) {
        case Slot::sorted_positions:
            return collides ? SLOT_POSITIONS : BINDING_GATHERED_POSITIONS;
        case Slot::sorted_velocities:
            return collides ? SLOT_VELOCITIES : BINDING_GATHERED_VELOCITIES;
        case Slot::used_tiles:
            return BINDING_USED_TILES;
        case Slot::tickets:
            return BINDING_TICKETS;
        case Slot::scattered_keys:
            return BINDING_SCATTERED_KEYS;
        case Slot::tile_counts:
            return BINDING_TILE_COUNTS;
        default:
            return static_cast<std::uint32_t>(slot);
    }
}

Schedule make_schedule(std::uint32_t ball_count, const Grid& grid, Features features, SortMethod sort,
                       std::uint32_t grid_reuse) {
    assert(sort != SortMethod::automatic);
    Schedule schedule;
    schedule.features = features;
    schedule.grid = grid;
    schedule.ball_count = ball_count;
    schedule.in_place = !features.has(Feature::contact);
    if (ball_count == 0) {
        return schedule;
    }
    const Builder builder{schedule};
    if (needs_grid(features)) {
        schedule.key_count = std::bit_ceil(ball_count);
        schedule.cell_count = grid.cell_count();
        schedule.counts_cells = sort == SortMethod::counting;
        builder.build_neighbour_grid(sort);
        schedule.keeps_places = grid_reuse > 1 && features.has(Feature::diagnostics);
        if (schedule.keeps_places) {
            builder.count_missed();
        }
    }
    builder.collide();
    return schedule;
}

Schedule with_grid_reused(Schedule schedule) {
    std::erase_if(schedule.dispatches, [](const Dispatch& dispatch) { return dispatch.stage != Stage::collide; });
    return schedule;
}

}  // namespace ballpit
