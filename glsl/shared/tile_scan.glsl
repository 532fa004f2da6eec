// A work group goes through a tile of the cell table: each thread has TILE_CELLS / TILE_GROUP_SIZE cells in a row, and
// sums over the group are made in shared memory.
#define THREAD_CELLS (TILE_CELLS / TILE_GROUP_SIZE)

shared uint partial[TILE_GROUP_SIZE];

// The sum of all threads' values, for each of them.
uint group_sum(uint value) {
    uint thread = gl_LocalInvocationIndex;
    barrier();   // nobody still reads the sums of the call before
    partial[thread] = value;
    for (uint half_size = TILE_GROUP_SIZE / 2u; half_size > 0u; half_size /= 2u) {
        memoryBarrierShared();
        barrier();
        if (thread < half_size) {
            partial[thread] += partial[thread + half_size];
        }
    }
    memoryBarrierShared();
    barrier();
    return partial[0];
}

// The sum of the values of all threads before this one.
uint sum_before(uint value) {
    uint thread = gl_LocalInvocationIndex;
    uint sum = value;
    barrier();
    partial[thread] = sum;
    for (uint distance = 1u; distance < TILE_GROUP_SIZE; distance *= 2u) {
        memoryBarrierShared();
        barrier();
        uint below = thread >= distance ? partial[thread - distance] : 0u;
        barrier();
        sum += below;
        partial[thread] = sum;
    }
    return sum - value;
}
