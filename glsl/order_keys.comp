#version 430 core
// One thread a slot: a key goes to the place in its cell's slots that its ball id has among them, so that the order of
// neighbours, and with it every sum, does not depend on which thread came first. A cell holds few balls: each looks at
// all of them. Where balls crowd it holds many, hence the slices. Where the order is kept, the ball's state goes with the
// key.
#include "shared/dispatch.glsl"
#include "shared/keys.glsl"

layout(local_size_x = GROUP_SIZE) in;

layout(std140, binding = BLOCK_PARAMS) uniform ParamsBlock {
    uint ball_count;
    uint cell_count;
} params;

layout(std430, binding = SLOT_CELL_RANGES) readonly buffer CellRangesBlock { CellRange cell_ranges[]; };
layout(std430, binding = BINDING_SCATTERED_KEYS) readonly buffer ScatteredKeysBlock { Key scattered_keys[]; };
#ifdef KEPT_ORDER
layout(std430, binding = BINDING_ORIGINS) readonly buffer OriginsBlock { uint origins[]; };
#include "shared/sorted_copies.glsl"
#endif

void main() {
    uint slot = sliced_index();
    if (slot >= params.ball_count) {
        return;
    }
    Key key = scattered_keys[slot];
    if (key.cell_id >= params.cell_count) {
        return;
    }
    CellRange range = cell_ranges[key.cell_id];
    uint place = range.first;
    for (uint other = range.first; other < range.end; ++other) {
        place += scattered_keys[other].ball_id < key.ball_id ? 1u : 0u;
    }
    keys[place] = key;
#ifdef KEPT_ORDER
    copy_state(origins[slot], place);
#endif
}
