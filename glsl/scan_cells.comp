#version 430 core
// One work group a tile of the cell table: from how many balls a cell has to the range of their slots. A range begins
// behind the balls of all tiles and cells before it.
#include "shared/dispatch.glsl"
#include "shared/used_tiles.glsl"
#include "shared/tile_scan.glsl"

layout(local_size_x = TILE_GROUP_SIZE) in;

layout(std140, binding = BLOCK_PARAMS) uniform ParamsBlock { uint cell_count; } params;

layout(std430, binding = SLOT_CELL_RANGES) buffer CellRangesBlock { CellRange cell_ranges[]; };
layout(std430, binding = BINDING_TILE_COUNTS) readonly buffer TileCountsBlock { uint tile_counts[]; };

// One number a cell and one for the end of the tile. Each thread has cells in a row, and threads next to each other must
// not ask the same bank of memory: after sixteen numbers one is left out.
shared uint numbers[TILE_CELLS + TILE_CELLS / THREAD_CELLS + 1];

uint place_of(uint cell) { return cell + cell / THREAD_CELLS; }

void main() {
    uint tile = group_index();
    uint first_cell = tile * TILE_CELLS;
    if (first_cell >= params.cell_count || used_tiles[tile] == 0u) {
        return;   // the whole group
    }
    uint thread = gl_LocalInvocationIndex;
    uint cells = min(params.cell_count - first_cell, TILE_CELLS);
    for (uint cell = thread; cell < TILE_CELLS; cell += TILE_GROUP_SIZE) {
        numbers[place_of(cell)] = cell < cells ? cell_ranges[first_cell + cell].end : 0u;
    }
    uint before = 0u;
    for (uint i = thread; i < tile; i += TILE_GROUP_SIZE) {
        before += tile_counts[i];
    }
    before = group_sum(before);   // after its barriers the counts are there, too

    uint own = 0u;
    for (uint i = 0u; i < THREAD_CELLS; ++i) {
        own += numbers[place_of(thread * THREAD_CELLS + i)];
    }
    uint first = before + sum_before(own);
    for (uint i = 0u; i < THREAD_CELLS; ++i) {
        uint place = place_of(thread * THREAD_CELLS + i);
        uint count = numbers[place];
        numbers[place] = first;   // from a count to the first slot
        first += count;
    }
    if (thread == TILE_GROUP_SIZE - 1u) {
        numbers[place_of(TILE_CELLS)] = first;
    }
    memoryBarrierShared();
    barrier();
    for (uint cell = thread; cell < cells; cell += TILE_GROUP_SIZE) {
        CellRange range = CellRange(numbers[place_of(cell)], numbers[place_of(cell + 1u)]);
        if (range.first < range.end) {   // an empty cell stays (0, 0)
            cell_ranges[first_cell + cell] = range;
        }
    }
}
