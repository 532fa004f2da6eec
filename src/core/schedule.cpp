#include "core/schedule.h"

#include <algorithm>
#include <bit>

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
            seen.add(Feature::diagnostics, features.has(Feature::diagnostics));
            break;
        case Shader::count_missed:
            seen.add(Feature::diagnostics, features.has(Feature::diagnostics));
            seen.add(Feature::unequal_radii, features.has(Feature::unequal_radii));
            break;
        case Shader::bitonic_sort:
        case Shader::bitonic_sort_fused:
        case Shader::clear_cells:
        case Shader::keep_places:
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

    // All passes with k_first <= k <= k_last and j <= j_first that stay inside a tile.
    void fused(std::uint32_t k_first, std::uint32_t k_last, std::uint32_t j_first) const {
        const std::string name =
            k_first == k_last
                ? "bitonic_sort_fused k=" + std::to_string(k_first) + " j=" + std::to_string(j_first) + "..1"
                : "bitonic_sort_fused k=" + std::to_string(k_first) + ".." + std::to_string(k_last);
        const std::uint32_t tiles = std::max(1u, schedule.key_count / SORT_TILE_SIZE);
        add(Stage::bitonic_sort, name, Shader::bitonic_sort_fused, groups_for(tiles, 1), {k_first, k_last, j_first, 0},
            {Slot::keys}, {Slot::keys});
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
        const std::uint32_t tile = std::min<std::uint32_t>(SORT_TILE_SIZE, schedule.key_count);
        fused(2, tile, 1);
        for (std::uint32_t k = 2 * tile; k <= schedule.key_count && k != 0; k *= 2) {
            std::uint32_t j = k / 2;
            for (; j >= tile; j /= 2) {
                pass(k, j);
            }
            fused(k, k, j);
        }
    }

    void build_neighbour_grid(SortMethod sort) const {
        add_diagnosed(Stage::assign_cells, "assign_cells", Shader::assign_cells,
                      groups_for(schedule.key_count, GROUP_SIZE), {Slot::positions}, {Slot::keys});
        sort == SortMethod::bitonic ? sort_pass_by_pass() : sort_fused();
        add(Stage::build_grid, "clear_cells", Shader::clear_cells, groups_for(schedule.cell_count, GROUP_SIZE), {}, {},
            {Slot::cell_ranges});
        add_diagnosed(Stage::build_grid, "build_grid", Shader::build_grid, groups_for(schedule.ball_count, GROUP_SIZE),
                      {Slot::keys}, {Slot::cell_ranges});
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
        std::vector<Slot> reads{Slot::positions, Slot::velocities};
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

Schedule make_schedule(std::uint32_t ball_count, const Grid& grid, Features features, SortMethod sort,
                       std::uint32_t grid_reuse) {
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
