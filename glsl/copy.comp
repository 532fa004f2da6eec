#version 430 core
// One thread 16 bytes, and nothing but moving them: how fast the device can be (`ballpit bench`). No part of a substep.
// dispatch_constants: how many times 16 bytes.
#include "shared/dispatch.glsl"

layout(local_size_x = GROUP_SIZE) in;

layout(std430, binding = SLOT_POSITIONS) readonly buffer FromBlock { uvec4 from[]; };
layout(std430, binding = SLOT_NEXT_POSITIONS) writeonly buffer ToBlock { uvec4 to[]; };

void main() {
    uint index = global_index();
    if (index < dispatch_constants.x) {
        to[index] = from[index];
    }
}
