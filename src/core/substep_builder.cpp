#include "core/substep_builder.h"

#include <algorithm>
#include <bit>
#include <initializer_list>

namespace ballpit {

namespace {

// Features that each shader looks at; the others must not split its permutations.
Features relevant(Shader shader, Features features) {
    const auto common = [features](std::initializer_list<Feature> looked_at) {
        Features seen;
        for (const Feature feature : looked_at) {
            seen.add(feature, features.has(feature));
        }
        return seen;
    };
    switch (shader) {
        case Shader::collide:
            return features;
        case Shader::build_grid:
        case Shader::count_cells:
            return common({Feature::diagnostics});
        case Shader::assign_cells:
            return common({Feature::diagnostics, Feature::kept_order});
        case Shader::count_missed:
            return common({Feature::diagnostics, Feature::unequal_radii, Feature::kept_order});
        case Shader::scatter_keys:
        case Shader::order_keys:
        case Shader::keep_places:
            return common({Feature::kept_order});
        case Shader::bitonic_sort:
        case Shader::bitonic_sort_fused:
        case Shader::bitonic_sort_strides:
        case Shader::clear_cells:
        case Shader::count_tiles:
        case Shader::scan_cells:
        case Shader::gather:
        case Shader::start_order:
        case Shader::put_back:
            break;
    }
    return {};
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
                                       {shader, relevant(shader, running_features())},
                                       groups,
                                       constants,
                                       std::move(reads),
                                       std::move(writes)});
    }

    Features running_features() const {
        return schedule.keeps_order ? schedule.features : schedule.features.without(Feature::kept_order);
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

    void clear_cells(Stage stage) const {
        add(stage, "clear_cells", Shader::clear_cells, groups_for(tile_count(schedule.cell_count), 1), {},
            {Slot::used_tiles}, {Slot::cell_ranges, Slot::used_tiles});
    }

    // From the sorted keys to the ranges.
    void sort_then_build(SortMethod sort) const {
        sort == SortMethod::bitonic ? sort_pass_by_pass() : sort_fused();
        clear_cells(Stage::build_grid);
        add_diagnosed(Stage::build_grid, "build_grid", Shader::build_grid, groups_for(schedule.ball_count, GROUP_SIZE),
                      {Slot::keys, Slot::used_tiles}, {Slot::cell_ranges, Slot::used_tiles});
    }

    void count_cells() const {
        add_diagnosed(Stage::build_grid, "count_cells", Shader::count_cells, ball_groups(),
                      {Slot::keys, Slot::cell_ranges, Slot::used_tiles},
                      {Slot::cell_ranges, Slot::used_tiles, Slot::tickets});
    }

    void scan_cells() const {
        const Groups tiles = groups_for(tile_count(schedule.cell_count), 1);
        add(Stage::build_grid, "count_tiles", Shader::count_tiles, tiles, {}, {Slot::cell_ranges, Slot::used_tiles},
            {Slot::tile_counts});
        add(Stage::build_grid, "scan_cells", Shader::scan_cells, tiles, {},
            {Slot::cell_ranges, Slot::used_tiles, Slot::tile_counts}, {Slot::cell_ranges});
    }

    // From the ranges to the sorted keys.
    void build_then_sort() const {
        clear_cells(Stage::build_grid);
        count_cells();
        scan_cells();
        add(Stage::counting_sort, "scatter_keys", Shader::scatter_keys, ball_groups(), {},
            {Slot::keys, Slot::cell_ranges, Slot::tickets}, {Slot::scattered_keys});
        add(Stage::counting_sort, "order_keys", Shader::order_keys, ball_groups(), {},
            {Slot::cell_ranges, Slot::scattered_keys}, {Slot::keys});
    }

    void build_neighbour_grid(SortMethod sort) const {
        add_diagnosed(Stage::assign_cells, "assign_cells", Shader::assign_cells,
                      groups_for(schedule.key_count, GROUP_SIZE), {Slot::positions}, {Slot::keys});
        schedule.counts_cells ? build_then_sort() : sort_then_build(sort);
    }

    void build_in_kept_order() const {
        clear_cells(Stage::assign_cells);
        add_diagnosed(Stage::assign_cells, "assign_cells", Shader::assign_cells,
                      groups_for(schedule.key_count, GROUP_SIZE),
                      {Slot::next_positions, Slot::keys, Slot::cell_ranges, Slot::used_tiles},
                      {Slot::keys, Slot::cell_ranges, Slot::used_tiles, Slot::tickets});
        scan_cells();
        add(Stage::counting_sort, "scatter_keys", Shader::scatter_keys, ball_groups(), {},
            {Slot::keys, Slot::cell_ranges, Slot::tickets}, {Slot::scattered_keys, Slot::origins});
        add(Stage::counting_sort, "order_keys", Shader::order_keys, ball_groups(), {},
            {Slot::cell_ranges, Slot::scattered_keys, Slot::origins, Slot::next_positions, Slot::next_velocities},
            {Slot::keys, Slot::sorted_positions, Slot::sorted_velocities});
    }

    // Both ask or tell where balls were when a grid was built: before the first look, then for the next one.
    void count_missed() const {
        const Slot positions = schedule.keeps_order ? Slot::sorted_positions : Slot::positions;
        add_diagnosed(Stage::build_grid, "count_missed", Shader::count_missed, ball_groups(),
                      {positions, Slot::keys, Slot::cell_ranges, Slot::built_positions}, {});
        std::vector<Slot> reads = {positions};
        if (schedule.keeps_order) {
            reads.push_back(Slot::keys);
        }
        add(Stage::build_grid, "keep_places", Shader::keep_places, ball_groups(), {}, std::move(reads),
            {Slot::built_positions});
    }

    void gather() const {
        add(Stage::collide, "gather", Shader::gather, ball_groups(), {},
            {Slot::positions, Slot::velocities, Slot::keys}, {Slot::sorted_positions, Slot::sorted_velocities});
    }

    void collide() const {
        const bool copies = schedule.features.has(Feature::sorted_copies);
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
        add_diagnosed(Stage::collide, "collide", Shader::collide, ball_groups(), std::move(reads), std::move(writes));
    }

    Groups ball_groups() const { return groups_for(schedule.ball_count, GROUP_SIZE); }
};

}  // namespace

bool needs_grid(Features features) { return features.has(Feature::contact) && !features.has(Feature::brute_force); }

void add_neighbour_grid(Schedule& schedule, SortMethod sort) { Builder{schedule}.build_neighbour_grid(sort); }

void add_grid_in_kept_order(Schedule& schedule) { Builder{schedule}.build_in_kept_order(); }

void add_count_missed(Schedule& schedule) { Builder{schedule}.count_missed(); }

void add_gather(Schedule& schedule) { Builder{schedule}.gather(); }

void add_collide(Schedule& schedule) { Builder{schedule}.collide(); }

}  // namespace ballpit
