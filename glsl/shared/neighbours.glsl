// Adds up the balls in the 27 cells around a ball, in the order of cells and slots. What add_pair() does to the
// NEIGHBOUR_SUM is its own; it is told where in `positions` and `velocities` the other ball is.

layout(std430, binding = SLOT_CELL_RANGES) readonly buffer CellRangesBlock { CellRange cell_ranges[]; };

// Cells that follow one another along x have slots that do, too: three of them are one range.
CellRange row_range(uvec3 middle, uint y, uint z) {
    CellRange row = CellRange(SENTINEL, 0u);
    if (y < params.grid_cells.y && z < params.grid_cells.z) {   // -1 is a large number, too
        uint cell = cell_id(uvec3(middle.x, y, z));
        CellRange ranges[3];   // at the end of a row the same cell twice, which changes nothing
        ranges[0] = cell_ranges[cell - min(middle.x, 1u)];
        ranges[1] = cell_ranges[cell];
        ranges[2] = cell_ranges[cell + min(params.grid_cells.x - 1u - middle.x, 1u)];
        for (uint i = 0u; i < 3u; ++i) {
            row.first = min(row.first, ranges[i].end > 0u ? ranges[i].first : SENTINEL);
            row.end = max(row.end, ranges[i].end);
        }
    }
    return row;
}

#ifdef KEPT_ORDER
uint place_of(uint slot) { return slot; }
#else
uint place_of(uint slot) { return keys[slot].ball_id; }
#endif

#ifdef SORTED_COPIES
// First all that are near enough are found, then their forces are added, both in one order. Threads next to each other
// find different ones: were each force added where its ball is found, nearly all of them would wait for a few each time.
// What is noted takes room that a cache could have: as much as twelve balls need, which is how many of one size can touch
// another at once, and one more; whoever overlaps with more adds up in between.
#define NEAR_SLOTS 13
shared uint near_slots[NEAR_SLOTS * GROUP_SIZE];

void add_near(Ball a, uint count, inout NEIGHBOUR_SUM sum) {
    for (uint i = 0u; i < count; ++i) {
        add_pair(a, near_slots[i * GROUP_SIZE + gl_LocalInvocationIndex], sum);
    }
}
#endif

void add_neighbours(Ball a, inout NEIGHBOUR_SUM sum) {
    uvec3 middle = cell_coordinates(a.position);
    CellRange rows[9];   // all at once: to ask memory for one after the other would take nine times as long
    for (uint row = 0u; row < 9u; ++row) {
        rows[row] = row_range(middle, middle.y + row % 3u - 1u, middle.z + row / 3u - 1u);
    }
#ifdef SORTED_COPIES
    uint count = 0u;
#endif
    for (uint row = 0u; row < 9u; ++row) {
        for (uint slot = rows[row].first; slot < rows[row].end; ++slot) {
#ifdef SORTED_COPIES
            if (within_reach(a, slot) && slot != a.place) {
                near_slots[count * GROUP_SIZE + gl_LocalInvocationIndex] = slot;
                if (++count == NEAR_SLOTS) {
                    add_near(a, count, sum);
                    count = 0u;
                }
            }
#else
            uint other = place_of(slot);
            if (other != a.id) {
                add_pair(a, other, sum);
            }
#endif
        }
    }
#ifdef SORTED_COPIES
    add_near(a, count, sum);
#endif
}
