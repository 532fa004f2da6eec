#version 430 core
// The passes whose pairs stay inside a tile (j < SORT_TILE_SIZE), one after the other in shared memory:
// one work group a tile, one barrier a pass instead of one dispatch a pass.
// dispatch_constants: first k, last k, j of the first pass.
#include "shared/dispatch.glsl"
#include "shared/keys.glsl"

layout(local_size_x = SORT_GROUP_SIZE) in;

layout(std140, binding = BLOCK_PARAMS) uniform ParamsBlock { uint key_count; } params;

shared Key tile[SORT_TILE_SIZE];

void compare_exchange(uint pair, uint first_slot, uint k, uint j) {
    uint lower = ((pair & ~(j - 1u)) << 1) | (pair & (j - 1u));
    uint upper = lower | j;
    bool ascending = ((first_slot + lower) & k) == 0u;
    Key a = tile[lower];
    Key b = tile[upper];
    if (key_less(b, a) == ascending) {
        tile[lower] = b;
        tile[upper] = a;
    }
}

void main() {
    uint first_slot = (gl_WorkGroupID.y * FOLDED_WIDTH + gl_WorkGroupID.x) * SORT_TILE_SIZE;
    // Fewer keys than a tile: the rest of the tile takes part as sentinels and is not written back.
    for (uint i = gl_LocalInvocationIndex; i < SORT_TILE_SIZE; i += SORT_GROUP_SIZE) {
        tile[i] = first_slot + i < params.key_count ? keys[first_slot + i] : Key(SENTINEL, SENTINEL);
    }
    uint j = dispatch_constants.z;
    for (uint k = dispatch_constants.x; k <= dispatch_constants.y; k *= 2u) {
        for (; j > 0u; j /= 2u) {
            memoryBarrierShared();
            barrier();
            for (uint pair = gl_LocalInvocationIndex; pair < SORT_TILE_SIZE / 2; pair += SORT_GROUP_SIZE) {
                compare_exchange(pair, first_slot, k, j);
            }
        }
        j = k;
    }
    memoryBarrierShared();
    barrier();
    for (uint i = gl_LocalInvocationIndex; i < SORT_TILE_SIZE && first_slot + i < params.key_count;
         i += SORT_GROUP_SIZE) {
        keys[first_slot + i] = tile[i];
    }
}
