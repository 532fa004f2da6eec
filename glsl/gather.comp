#version 430 core
// One thread a slot: copies of the state in the order of the sorted keys, so that balls that are near each other lie near
// each other in memory, where collide reads them.
#include "shared/dispatch.glsl"
#include "shared/keys.glsl"

layout(local_size_x = GROUP_SIZE) in;

layout(std140, binding = BLOCK_PARAMS) uniform ParamsBlock { uint ball_count; } params;

layout(std430, binding = SLOT_POSITIONS) readonly buffer PositionsBlock { vec4 positions[]; };
layout(std430, binding = SLOT_VELOCITIES) readonly buffer VelocitiesBlock { vec4 velocities[]; };
layout(std430, binding = BINDING_GATHERED_POSITIONS) writeonly buffer SortedPositionsBlock { vec4 sorted_positions[]; };
layout(std430, binding = BINDING_GATHERED_VELOCITIES) writeonly buffer SortedVelocitiesBlock {
    vec4 sorted_velocities[];
};

void main() {
    uint slot = global_index();
    if (slot >= params.ball_count) {
        return;
    }
    uint ball = keys[slot].ball_id;
    if (ball < params.ball_count) {
        sorted_positions[slot] = positions[ball];
        sorted_velocities[slot] = velocities[ball];
    }
}
