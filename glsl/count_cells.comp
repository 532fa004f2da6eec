#version 430 core
// One thread a ball: it is counted into its cell, and takes a ticket.
#include "shared/dispatch.glsl"
#ifdef DIAGNOSTICS
#include "shared/status.glsl"
#endif
#include "shared/keys.glsl"
#include "shared/tickets.glsl"

layout(local_size_x = GROUP_SIZE) in;

layout(std140, binding = BLOCK_PARAMS) uniform ParamsBlock {
    uint ball_count;
    uint cell_count;
} params;

void main() {
    uint ball = global_index();
    if (ball >= params.ball_count) {
        return;
    }
    uint cell = keys[ball].cell_id;
    if (cell >= params.cell_count) {
#ifdef DIAGNOSTICS
        atomicOr(status.bits, STATUS_OVER_CAPACITY);
        atomicAdd(status.over_capacity, 1u);
#endif
        return;
    }
    take_ticket(ball, cell);
}
