#version 430 core
// Up to three passes of the bitonic network whose pairs reach beyond a tile, in one go: memory is read and written once
// instead of three times.
// dispatch_constants: k, j of the first pass, passes.
#include "shared/dispatch.glsl"
#include "shared/keys.glsl"
#include "shared/exchange.glsl"

layout(local_size_x = GROUP_SIZE) in;

layout(std140, binding = BLOCK_PARAMS) uniform ParamsBlock { uint key_count; } params;

void main() {
    uint thread = global_index();
    if (thread >= params.key_count / STRIDE_KEYS) {
        return;
    }
    uint passes = dispatch_constants.z;
    uint stride = dispatch_constants.y >> (passes - 1u);   // j of the last pass
    uint first = first_of_eight(thread, stride);
    Key own[STRIDE_KEYS];
    for (uint i = 0u; i < STRIDE_KEYS; ++i) {
        own[i] = keys[first + i * stride];
    }
    exchange_eight(own, first, stride, dispatch_constants.x, passes);
    for (uint i = 0u; i < STRIDE_KEYS; ++i) {
        keys[first + i * stride] = own[i];
    }
}
