// Adds up the balls in the 27 cells around a ball, in the order of cells and slots. What add_pair() does to the
// NEIGHBOUR_SUM is its own.

layout(std430, binding = SLOT_CELL_RANGES) readonly buffer CellRangesBlock { CellRange cell_ranges[]; };

void add_neighbours(Ball a, inout NEIGHBOUR_SUM sum) {
    uvec3 middle = cell_coordinates(a.position);
    uvec3 low = middle - min(middle, uvec3(1u));
    uvec3 high = min(middle + 1u, params.grid_cells - 1u);
    for (uint z = low.z; z <= high.z; ++z) {
        for (uint y = low.y; y <= high.y; ++y) {
            for (uint x = low.x; x <= high.x; ++x) {
                CellRange range = cell_ranges[cell_id(uvec3(x, y, z))];
                for (uint slot = range.first; slot < range.end; ++slot) {
                    uint id = keys[slot].ball_id;
                    if (id != a.id) {
                        add_pair(a, id, sum);
                    }
                }
            }
        }
    }
}
