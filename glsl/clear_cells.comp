#version 430 core
// One thread a cell: every cell is empty until build_grid says otherwise.
#include "shared/dispatch.glsl"

layout(local_size_x = GROUP_SIZE) in;

layout(std140, binding = BLOCK_PARAMS) uniform ParamsBlock { uint cell_count; } params;

layout(std430, binding = SLOT_CELL_RANGES) writeonly buffer CellRangesBlock { CellRange cell_ranges[]; };

void main() {
    uint cell = global_index();
    if (cell < params.cell_count) {
        cell_ranges[cell] = CellRange(0u, 0u);
    }
}
