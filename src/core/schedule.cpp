#include "core/schedule.h"

#include <algorithm>
#include <bit>
#include <cassert>

#include "core/substep_builder.h"

namespace ballpit {

namespace {

Dispatch between_orders(Stage stage, Shader shader, std::uint32_t ball_count, std::vector<Slot> reads,
                        std::vector<Slot> writes) {
    return {stage,
            std::string(shader_name(shader)),
            {shader, {}},
            groups_for(ball_count, GROUP_SIZE),
            {ball_count, 0, 0, 0},
            std::move(reads),
            std::move(writes)};
}

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
    const bool copies = shader == Shader::gather || shader == Shader::order_keys;
    const bool reads_next = shader == Shader::assign_cells || shader == Shader::order_keys;
    switch (slot) {
        case Slot::next_positions:
            return reads_next ? SLOT_POSITIONS : SLOT_NEXT_POSITIONS;
        case Slot::next_velocities:
            return reads_next ? SLOT_VELOCITIES : SLOT_NEXT_VELOCITIES;
        case Slot::sorted_positions:
            return copies ? BINDING_GATHERED_POSITIONS : SLOT_POSITIONS;
        case Slot::sorted_velocities:
            return copies ? BINDING_GATHERED_VELOCITIES : SLOT_VELOCITIES;
        case Slot::used_tiles:
            return BINDING_USED_TILES;
        case Slot::tickets:
            return BINDING_TICKETS;
        case Slot::origins:
            return BINDING_ORIGINS;
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
    schedule.swaps_states = !schedule.in_place;
    if (ball_count == 0) {
        return schedule;
    }
    if (needs_grid(features)) {
        schedule.key_count = std::bit_ceil(ball_count);
        schedule.cell_count = grid.cell_count();
        schedule.counts_cells = sort == SortMethod::counting;
        add_neighbour_grid(schedule, sort);
        schedule.keeps_places = grid_reuse > 1 && features.has(Feature::diagnostics);
        if (schedule.keeps_places) {
            add_count_missed(schedule);
        }
    }
    if (features.has(Feature::sorted_copies)) {
        add_gather(schedule);
    }
    add_collide(schedule);
    return schedule;
}

Schedule with_grid_reused(Schedule schedule) {
    std::erase_if(schedule.dispatches, [](const Dispatch& dispatch) { return dispatch.stage != Stage::collide; });
    schedule.swaps_copies = schedule.keeps_order;
    return schedule;
}

bool can_keep_order(const Schedule& schedule) {
    return schedule.features.has(Feature::kept_order) && schedule.counts_cells;
}

Schedule keeping_order(const Schedule& schedule) {
    assert(can_keep_order(schedule));
    Schedule kept = schedule;
    kept.dispatches.clear();
    kept.swaps_states = false;
    kept.keeps_order = true;
    add_grid_in_kept_order(kept);
    if (kept.keeps_places) {
        add_count_missed(kept);
    }
    add_collide(kept);
    return kept;
}

Dispatch start_order(std::uint32_t ball_count) {
    return between_orders(Stage::assign_cells, Shader::start_order, ball_count, {Slot::positions, Slot::velocities},
                          {Slot::next_positions, Slot::next_velocities, Slot::keys});
}

Dispatch put_back(std::uint32_t ball_count) {
    return between_orders(Stage::collide, Shader::put_back, ball_count,
                          {Slot::next_positions, Slot::next_velocities, Slot::keys},
                          {Slot::positions, Slot::velocities});
}

Schedule there_and_back(const Schedule& schedule) {
    Schedule both = keeping_order(schedule);
    both.keeps_order = false;
    both.dispatches.insert(both.dispatches.begin(), start_order(both.ball_count));
    both.dispatches.push_back(put_back(both.ball_count));
    return both;
}

}  // namespace ballpit
