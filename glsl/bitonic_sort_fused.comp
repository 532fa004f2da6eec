#version 430 core
// The passes whose pairs stay inside a tile, one after the other in shared memory: one work group
// a tile. A thread takes eight keys through up to three passes at a time, so there is a barrier for three passes.
// dispatch_constants: first k, last k, j of the first pass.
#include "shared/dispatch.glsl"
#include "shared/keys.glsl"
#include "shared/exchange.glsl"

#ifdef SMALL_TILES
#define TILE_SIZE SORT_SMALL_TILE_SIZE
#define THREADS SORT_SMALL_GROUP_SIZE
#else
#define TILE_SIZE SORT_TILE_SIZE
#define THREADS SORT_GROUP_SIZE
#endif

layout(local_size_x = THREADS) in;

layout(std140, binding = BLOCK_PARAMS) uniform ParamsBlock { uint key_count; } params;

shared Key tile[TILE_SIZE];

// Where a slot of the tile lies in shared memory: threads next to each other would otherwise ask the same bank.
uint place_of(uint slot) { return slot ^ (slot >> 4u & 15u); }

void exchange_in_tile(uint first_slot, uint k, uint j, uint passes) {
    uint stride = j >> (passes - 1u);
    uint first = first_of_eight(gl_LocalInvocationIndex, stride);
    Key own[STRIDE_KEYS];
    for (uint i = 0u; i < STRIDE_KEYS; ++i) {
        own[i] = tile[place_of(first + i * stride)];
    }
    exchange_eight(own, first_slot + first, stride, k, passes);
    for (uint i = 0u; i < STRIDE_KEYS; ++i) {
        tile[place_of(first + i * stride)] = own[i];
    }
}

void main() {
    uint first_slot = group_index() * TILE_SIZE;
    // Fewer keys than a tile: the rest of the tile takes part as sentinels and is not written back.
    for (uint i = gl_LocalInvocationIndex; i < TILE_SIZE; i += THREADS) {
        tile[place_of(i)] = first_slot + i < params.key_count ? keys[first_slot + i] : Key(SENTINEL, SENTINEL);
    }
    uint j = dispatch_constants.z;
    for (uint k = dispatch_constants.x; k <= dispatch_constants.y; k *= 2u) {
        while (j > 0u) {
            uint passes = min(uint(findMSB(j)) + 1u, 3u);
            memoryBarrierShared();
            barrier();
            exchange_in_tile(first_slot, k, j, passes);
            j >>= passes;
        }
        j = k;
    }
    memoryBarrierShared();
    barrier();
    for (uint i = gl_LocalInvocationIndex; i < TILE_SIZE && first_slot + i < params.key_count;
         i += THREADS) {
        keys[first_slot + i] = tile[place_of(i)];
    }
}
