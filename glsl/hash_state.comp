#version 430 core
// One thread a ball: the state hash as two sums, each word mixed with its place (src/core/hash.h). Whole numbers add
// up to the same in any order. A group adds up its own part first: one pair of atomics a group, not a ball.
// dispatch_constants: the entry of the ring, the number of balls.
#include "shared/layout.h"

layout(local_size_x = GROUP_SIZE) in;

uniform uvec4 dispatch_constants;

layout(std430, binding = SLOT_POSITIONS) readonly buffer PositionsBlock { vec4 positions[]; };
layout(std430, binding = SLOT_VELOCITIES) readonly buffer VelocitiesBlock { vec4 velocities[]; };
layout(std430, binding = BINDING_HASHES) buffer HashesBlock { HashSum hashes[]; };

shared uint group_low;
shared uint group_high;

uint mix_word(uint h) {
    h = (h ^ (h >> 16)) * 0x85EBCA6Bu;
    h = (h ^ (h >> 13)) * 0xC2B2AE35u;
    return h ^ (h >> 16);
}

void add(uvec4 words, uint place, inout uvec2 sum) {
    for (uint c = 0u; c < 4u; ++c) {
        uint h = mix_word(words[c] + mix_word(place + c + 1u));
        sum += uvec2(h, mix_word(h ^ 0x9E3779B9u));
    }
}

void main() {
    if (gl_LocalInvocationIndex == 0u) {
        group_low = 0u;
        group_high = 0u;
    }
    memoryBarrierShared();
    barrier();
    uint ball = gl_GlobalInvocationID.y * (FOLDED_WIDTH * GROUP_SIZE) + gl_GlobalInvocationID.x;
    if (ball < dispatch_constants.y) {
        uvec2 sum = uvec2(0u);
        add(floatBitsToUint(positions[ball]), 8u * ball, sum);
        add(floatBitsToUint(velocities[ball]), 8u * ball + 4u, sum);
        atomicAdd(group_low, sum.x);
        atomicAdd(group_high, sum.y);
    }
    memoryBarrierShared();
    barrier();
    if (gl_LocalInvocationIndex == 0u) {
        atomicAdd(hashes[dispatch_constants.x].low, group_low);
        atomicAdd(hashes[dispatch_constants.x].high, group_high);
    }
}
