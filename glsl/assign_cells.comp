#version 430 core
// One thread a key: ball -> (cell id, ball id); the padding up to the next power of two gets sentinels. Where the order
// is kept, the keys of the substep before tell which ball is where, and balls are counted into their cells at once.
#include "shared/dispatch.glsl"
#ifdef DIAGNOSTICS
#include "shared/status.glsl"
#endif
#include "shared/keys.glsl"

layout(local_size_x = GROUP_SIZE) in;

layout(std140, binding = BLOCK_PARAMS) uniform ParamsBlock {
    vec3 grid_origin;            // m: lower corner of cell 0
    float inverse_cell_width;    // 1/m
    uvec3 grid_cells;            // cells along x, y, z
    uint ball_count;
    uint key_count;              // next power of two of ball_count
#ifdef DIAGNOSTICS
    vec3 box_lower;              // m
    vec3 box_upper;
#endif
} params;

#include "shared/cells.glsl"
#ifdef KEPT_ORDER
#include "shared/tickets.glsl"
#endif

layout(std430, binding = SLOT_POSITIONS) readonly buffer PositionsBlock { vec4 positions[]; };

void main() {
    uint place = global_index();
    if (place >= params.key_count) {
        return;
    }
    if (place >= params.ball_count) {
        keys[place] = Key(SENTINEL, SENTINEL);
        return;
    }
    vec3 centre = positions[place].xyz;
    uint cell = cell_id(cell_coordinates(centre));
#ifdef KEPT_ORDER
    keys[place] = Key(cell, keys[place].ball_id);
    take_ticket(place, cell);
#else
    keys[place] = Key(cell, place);
#endif
#ifdef DIAGNOSTICS
    if (any(lessThan(centre, params.box_lower)) || any(greaterThan(centre, params.box_upper))) {
        atomicOr(status.bits, STATUS_OUT_OF_BOUNDS);
        atomicAdd(status.out_of_bounds, 1u);
    }
#endif
}
