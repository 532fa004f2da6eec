#version 430 core
// One work group a tile of the cell table: how many balls its cells hold.
#include "shared/dispatch.glsl"
#include "shared/used_tiles.glsl"
#include "shared/tile_scan.glsl"

layout(local_size_x = TILE_GROUP_SIZE) in;

layout(std140, binding = BLOCK_PARAMS) uniform ParamsBlock { uint cell_count; } params;

layout(std430, binding = SLOT_CELL_RANGES) readonly buffer CellRangesBlock { CellRange cell_ranges[]; };
layout(std430, binding = BINDING_TILE_COUNTS) writeonly buffer TileCountsBlock { uint tile_counts[]; };

void main() {
    uint tile = group_index();
    uint first_cell = tile * TILE_CELLS;
    if (first_cell >= params.cell_count) {
        return;   // the whole group
    }
    uint count = 0u;
    if (used_tiles[tile] != 0u) {
        uint end = min(first_cell + TILE_CELLS, params.cell_count);
        for (uint cell = first_cell + gl_LocalInvocationIndex; cell < end; cell += TILE_GROUP_SIZE) {
            count += cell_ranges[cell].end;
        }
        count = group_sum(count);
    }
    if (gl_LocalInvocationIndex == 0u) {
        tile_counts[tile] = count;
    }
}
