#version 430 core
// One thread a ball: remembers where balls are now that a grid has been built, for count_missed to compare with.
// Where the order is kept, one a slot, and the sorted copies tell.
#include "shared/dispatch.glsl"
#ifdef KEPT_ORDER
#include "shared/keys.glsl"
#endif

layout(local_size_x = GROUP_SIZE) in;

layout(std140, binding = BLOCK_PARAMS) uniform ParamsBlock {
    uint ball_count;
} params;

layout(std430, binding = SLOT_POSITIONS) readonly buffer PositionsBlock { vec4 positions[]; };
layout(std430, binding = SLOT_BUILT_POSITIONS) writeonly buffer BuiltPositionsBlock { vec4 built_positions[]; };

void main() {
    uint place = global_index();
    if (place < params.ball_count) {
#ifdef KEPT_ORDER
        built_positions[keys[place].ball_id] = positions[place];
#else
        built_positions[place] = positions[place];
#endif
    }
}
