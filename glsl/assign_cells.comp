#version 430 core
// One thread a key: ball -> (cell id, ball id); the padding up to the next power of two gets sentinels.
#include "shared/params.glsl"
#include "shared/status.glsl"
#include "shared/keys.glsl"
#include "shared/cells.glsl"

layout(local_size_x = GROUP_SIZE) in;

layout(std430, binding = SLOT_POSITIONS) readonly buffer PositionsBlock { vec4 positions[]; };

void main() {
    uint ball = global_index();
    if (ball >= params.key_count) {
        return;
    }
    if (ball >= params.ball_count) {
        keys[ball] = Key(SENTINEL, SENTINEL);
        return;
    }
    vec3 centre = positions[ball].xyz;
    keys[ball] = Key(cell_id(cell_coordinates(centre)), ball);
    if (any(greaterThan(abs(centre), params.half_extent))) {
        atomicOr(status.bits, STATUS_OUT_OF_BOUNDS);
        atomicAdd(status.out_of_bounds, 1u);
    }
}
