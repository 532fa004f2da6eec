#version 430 core
// One thread a slot: the state of its ball, copied into the order of the sorted keys.
#include "shared/dispatch.glsl"
#include "shared/keys.glsl"
#include "shared/sorted_copies.glsl"

layout(local_size_x = GROUP_SIZE) in;

layout(std140, binding = BLOCK_PARAMS) uniform ParamsBlock { uint ball_count; } params;

void main() {
    uint slot = global_index();
    if (slot >= params.ball_count) {
        return;
    }
    uint ball = keys[slot].ball_id;
    if (ball < params.ball_count) {
        copy_state(ball, slot);
    }
}
