#version 430 core
// One thread a slot: from the order that is kept back to that of the balls' ids, for whoever looks at them.
#include "shared/dispatch.glsl"
#include "shared/keys.glsl"

layout(local_size_x = GROUP_SIZE) in;

layout(std430, binding = SLOT_POSITIONS) writeonly buffer PositionsBlock { vec4 positions[]; };
layout(std430, binding = SLOT_VELOCITIES) writeonly buffer VelocitiesBlock { vec4 velocities[]; };
layout(std430, binding = SLOT_NEXT_POSITIONS) readonly buffer NextPositionsBlock { vec4 next_positions[]; };
layout(std430, binding = SLOT_NEXT_VELOCITIES) readonly buffer NextVelocitiesBlock { vec4 next_velocities[]; };

void main() {
    uint slot = global_index();
    if (slot >= dispatch_constants.x) {
        return;
    }
    uint ball = keys[slot].ball_id;
    if (ball < dispatch_constants.x) {
        positions[ball] = next_positions[slot];
        velocities[ball] = next_velocities[slot];
    }
}
