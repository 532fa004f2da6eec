#version 430 core
// One work group adds up what the groups of meter have left, in their order: METER_LANES sums side by side, then those.
// dispatch_constants: the entry of the ring, the number of parts.
#include "shared/layout.h"

layout(local_size_x = METER_LANES, local_size_y = METER_VALUES) in;

uniform uvec4 dispatch_constants;

layout(std430, binding = BINDING_METER_PARTS) readonly buffer PartsBlock { float parts[]; };
layout(std430, binding = BINDING_METER_RING) writeonly buffer RingBlock { float ring[]; };

shared float lanes[METER_VALUES][METER_LANES];

// A million balls have 16000 parts: what rounding leaves out is kept (Kahan 1965, Communications of the ACM 8, 40).
void add(float value, inout float total, inout float left_out) {
    precise float wanted = value + left_out;
    precise float sum = total + wanted;
    precise float added = sum - total;
    precise float rest = wanted - added;
    total = sum;
    left_out = rest;
}

void main() {
    uint lane = gl_LocalInvocationID.x;
    uint value = gl_LocalInvocationID.y;
    float total = 0.0;
    float left_out = 0.0;
    for (uint part = lane; part < dispatch_constants.y; part += METER_LANES) {
        float next = parts[part * METER_VALUES + value];
        if (value < METER_SUMS) {
            add(next, total, left_out);
        } else {
            total = max(total, next);
        }
    }
    lanes[value][lane] = total;
    memoryBarrierShared();
    barrier();
    if (lane == 0u) {
        total = 0.0;
        left_out = 0.0;
        for (uint i = 0u; i < METER_LANES; ++i) {
            if (value < METER_SUMS) {
                add(lanes[value][i], total, left_out);
            } else {
                total = max(total, lanes[value][i]);
            }
        }
        ring[dispatch_constants.x * METER_VALUES + value] = total;
    }
}
