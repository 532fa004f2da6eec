#version 430 core
// One thread a ball: its key goes into the slots of its cell, at the place that its ticket names; where the order is kept,
// with the place where the ball is now.
#include "shared/dispatch.glsl"
#include "shared/keys.glsl"

layout(local_size_x = GROUP_SIZE) in;

layout(std140, binding = BLOCK_PARAMS) uniform ParamsBlock {
    uint ball_count;
    uint cell_count;
} params;

layout(std430, binding = SLOT_CELL_RANGES) readonly buffer CellRangesBlock { CellRange cell_ranges[]; };
layout(std430, binding = BINDING_TICKETS) readonly buffer TicketsBlock { uint tickets[]; };
layout(std430, binding = BINDING_SCATTERED_KEYS) writeonly buffer ScatteredKeysBlock { Key scattered_keys[]; };
#ifdef KEPT_ORDER
layout(std430, binding = BINDING_ORIGINS) writeonly buffer OriginsBlock { uint origins[]; };
#endif

void main() {
    uint place = global_index();
    if (place >= params.ball_count) {
        return;
    }
    Key key = keys[place];
    if (key.cell_id < params.cell_count) {
        uint slot = cell_ranges[key.cell_id].first + tickets[place];
        scattered_keys[slot] = key;
#ifdef KEPT_ORDER
        origins[slot] = place;
#endif
    }
}
