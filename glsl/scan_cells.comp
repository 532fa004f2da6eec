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

// How many balls four cells in a row have. One after the other in the text: the sixteen reads of a thread wait together.
uvec4 counts_of(uint cell) {
    uint last = params.cell_count - 1u;
    uvec4 counts = uvec4(cell_ranges[min(cell, last)].end, cell_ranges[min(cell + 1u, last)].end,
                         cell_ranges[min(cell + 2u, last)].end, cell_ranges[min(cell + 3u, last)].end);
    return counts * uvec4(lessThanEqual(uvec4(cell) + uvec4(0u, 1u, 2u, 3u), uvec4(last)));
}

uint total(uvec4 counts) { return counts.x + counts.y + counts.z + counts.w; }

// Gives four cells their ranges, the first one from slot `first` on, and returns the slot behind them.
uint give_ranges(uint cell, uvec4 counts, uint first) {
    for (uint i = 0u; i < 4u; ++i) {
        if (counts[i] > 0u) {   // an empty cell stays (0, 0)
            cell_ranges[cell + i] = CellRange(first, first + counts[i]);
        }
        first += counts[i];
    }
    return first;
}

void main() {
    uint tile = group_index();
    uint tile_cell = tile * TILE_CELLS;
    if (tile_cell >= params.cell_count || used_tiles[tile] == 0u) {
        return;   // the whole group
    }
    uint before = 0u;
    for (uint i = gl_LocalInvocationIndex; i < tile; i += TILE_GROUP_SIZE) {
        before += tile_counts[i];
    }
    uint cell = tile_cell + gl_LocalInvocationIndex * THREAD_CELLS;
    uvec4 a = counts_of(cell);
    uvec4 b = counts_of(cell + 4u);
    uvec4 c = counts_of(cell + 8u);
    uvec4 d = counts_of(cell + 12u);
    uint first = group_sum(before) + sum_before(total(a) + total(b) + total(c) + total(d));
    first = give_ranges(cell, a, first);
    first = give_ranges(cell + 4u, b, first);
    first = give_ranges(cell + 8u, c, first);
    give_ranges(cell + 12u, d, first);
}
