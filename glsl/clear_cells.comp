#version 430 core
// One work group a tile of the cell table: every cell is empty until it is said otherwise. Tiles that nothing was
// written to are empty already.
#include "shared/dispatch.glsl"
#include "shared/used_tiles.glsl"

layout(local_size_x = TILE_GROUP_SIZE) in;

layout(std140, binding = BLOCK_PARAMS) uniform ParamsBlock { uint cell_count; } params;

layout(std430, binding = SLOT_CELL_RANGES) writeonly buffer CellRangesBlock { CellRange cell_ranges[]; };

void main() {
    uint tile = group_index();
    uint first_cell = tile * TILE_CELLS;
    if (first_cell >= params.cell_count || used_tiles[tile] == 0u) {
        return;   // the whole group
    }
    barrier();    // all have looked
    if (gl_LocalInvocationIndex == 0u) {
        used_tiles[tile] = 0u;
    }
    uint end = min(first_cell + TILE_CELLS, params.cell_count);
    for (uint cell = first_cell + gl_LocalInvocationIndex; cell < end; cell += TILE_GROUP_SIZE) {
        cell_ranges[cell] = CellRange(0u, 0u);
    }
}
