#version 430 core
// One thread a ball, where a grid is used by several substeps: a new grid has been built, and tells what the one before
// it would not show any more. collide looks for balls around the place where a ball is now, and finds them in the cells
// where they were when the grid was built. So nobody misses a ball that is still in the cell where it was; around any
// other one its thread asks who touches it, and from where they would look.
#include "shared/dispatch.glsl"
#include "shared/status.glsl"

layout(local_size_x = GROUP_SIZE) in;

layout(std140, binding = BLOCK_PARAMS) uniform ParamsBlock {
    vec3 grid_origin;            // m: lower corner of cell 0
    float inverse_cell_width;    // 1/m
    uvec3 grid_cells;            // cells along x, y, z
    uint ball_count;
#ifndef LAW_UNEQUAL_RADII
    float radius;                // m, of every ball
#endif
} params;

// Where the order is kept these are the sorted copies, and a thread has a slot.
layout(std430, binding = SLOT_POSITIONS) readonly buffer PositionsBlock { vec4 positions[]; };
layout(std430, binding = SLOT_BUILT_POSITIONS) readonly buffer BuiltPositionsBlock { vec4 built_positions[]; };

struct Ball {
    uint id;                     // its place in `positions`
    vec3 position;
    float radius;
    uvec3 built_cell;            // where the grid before has it
};

struct Missed {
    uint count;
};

#define NEIGHBOUR_SUM Missed
#include "shared/keys.glsl"
#include "shared/cells.glsl"

float radius_of(vec4 position) {
#ifdef LAW_UNEQUAL_RADII
    return position.w;
#else
    return params.radius;
#endif
}

float length_squared(vec3 a) {
    precise float sum = a.x * a.x + a.y * a.y + a.z * a.z;
    return sum;
}

bool are_adjacent(uvec3 a, uvec3 b) { return all(lessThanEqual(abs(ivec3(a) - ivec3(b)), ivec3(1))); }

void add_pair(Ball a, uint other, inout Missed missed) {
    vec4 position = positions[other];
    precise vec3 offset = a.position - position.xyz;
    precise float reach = a.radius + radius_of(position);
    precise float reach_squared = reach * reach;
    if (position.w > 0.0 && length_squared(offset) < reach_squared &&
        !are_adjacent(cell_coordinates(position.xyz), a.built_cell)) {
        ++missed.count;
    }
}

#include "shared/neighbours.glsl"

shared uint farthest;

void main() {
    if (gl_LocalInvocationIndex == 0u) {
        farthest = 0u;
    }
    barrier();
    uint id = sliced_index();
    if (id < params.ball_count) {
#ifdef KEPT_ORDER
        vec4 built_position = built_positions[keys[id].ball_id];
#else
        vec4 built_position = built_positions[id];
#endif
        vec4 position = positions[id];
        precise vec3 way = position.xyz - built_position.xyz;
        float way_squared = length_squared(way);
        atomicMax(farthest, floatBitsToUint(isnan(way_squared) ? 0.0 : way_squared));   // in order, as none is negative
        Missed missed = Missed(0u);
        uvec3 built_cell = cell_coordinates(built_position.xyz);
        if (position.w > 0.0 && built_cell != cell_coordinates(position.xyz)) {   // those in quarantine touch nobody
            add_neighbours(Ball(id, position.xyz, radius_of(position), built_cell), missed);
        }
        if (missed.count > 0u) {
            atomicOr(status.bits, STATUS_MISSED);
            atomicAdd(status.missed, missed.count);
        }
    }
    barrier();
    if (gl_LocalInvocationIndex == 0u) {
        atomicMax(status.drift_bits, farthest);
    }
}
