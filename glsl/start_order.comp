#version 430 core
// One thread a ball: a first order to keep, that of the balls' ids. The next substep finds each ball somewhere, and where
// that is does not matter to it.
#include "shared/dispatch.glsl"
#include "shared/keys.glsl"

layout(local_size_x = GROUP_SIZE) in;

layout(std430, binding = SLOT_POSITIONS) readonly buffer PositionsBlock { vec4 positions[]; };
layout(std430, binding = SLOT_VELOCITIES) readonly buffer VelocitiesBlock { vec4 velocities[]; };
layout(std430, binding = SLOT_NEXT_POSITIONS) writeonly buffer NextPositionsBlock { vec4 next_positions[]; };
layout(std430, binding = SLOT_NEXT_VELOCITIES) writeonly buffer NextVelocitiesBlock { vec4 next_velocities[]; };

void main() {
    uint ball = global_index();
    if (ball < dispatch_constants.x) {
        next_positions[ball] = positions[ball];
        next_velocities[ball] = velocities[ball];
        keys[ball] = Key(SENTINEL, ball);
    }
}
