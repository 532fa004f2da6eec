#version 430 core
// One thread a ball: remembers where balls are now that a grid has been built, for count_missed to compare with.
#include "shared/dispatch.glsl"

layout(local_size_x = GROUP_SIZE) in;

layout(std140, binding = BLOCK_PARAMS) uniform ParamsBlock {
    uint ball_count;
} params;

layout(std430, binding = SLOT_POSITIONS) readonly buffer PositionsBlock { vec4 positions[]; };
layout(std430, binding = SLOT_BUILT_POSITIONS) writeonly buffer BuiltPositionsBlock { vec4 built_positions[]; };

void main() {
    uint ball = global_index();
    if (ball < params.ball_count) {
        built_positions[ball] = positions[ball];
    }
}
