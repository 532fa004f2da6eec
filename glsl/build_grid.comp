#version 430 core
// One thread a slot: compares with both neighbours; only the slot at a boundary writes, so there is no race.
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

void main() {
    uint slot = global_index();
    if (slot >= params.ball_count) {
        return;
    }
    uint cell = keys[slot].cell_id;
    if (cell >= params.cell_count) {
#ifdef DIAGNOSTICS
        atomicOr(status.bits, STATUS_OVER_CAPACITY);
        atomicAdd(status.over_capacity, 1u);
#endif
        return;
    }
    if (slot == 0u || keys[slot - 1u].cell_id != cell) {
        cell_ranges[cell].first = slot;
        mark_tile(cell);
    }
    if (slot + 1u == params.ball_count || keys[slot + 1u].cell_id != cell) {
        cell_ranges[cell].end = slot + 1u;
    }
}
