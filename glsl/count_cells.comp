#version 430 core
// One thread a ball: it is counted into its cell, and takes a ticket: how many were counted before it. Which of the
// balls of a cell gets which ticket depends on who comes first; order_keys makes up for that.
#include "shared/dispatch.glsl"
#ifdef DIAGNOSTICS
#include "shared/status.glsl"
#endif
#include "shared/keys.glsl"
#include "shared/used_tiles.glsl"

layout(local_size_x = GROUP_SIZE) in;

layout(std140, binding = BLOCK_PARAMS) uniform ParamsBlock {
    uint ball_count;
    uint cell_count;
} params;

layout(std430, binding = SLOT_CELL_RANGES) buffer CellRangesBlock { CellRange cell_ranges[]; };
layout(std430, binding = BINDING_TICKETS) writeonly buffer TicketsBlock { uint tickets[]; };

void main() {
    uint ball = global_index();
    if (ball >= params.ball_count) {
        return;
    }
    uint cell = keys[ball].cell_id;
    if (cell >= params.cell_count) {
#ifdef DIAGNOSTICS
        atomicOr(status.bits, STATUS_OVER_CAPACITY);
        atomicAdd(status.over_capacity, 1u);
#endif
        return;
    }
    tickets[ball] = atomicAdd(cell_ranges[cell].end, 1u);
    mark_tile(cell);
}
