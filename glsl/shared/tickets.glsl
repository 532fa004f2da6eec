// Counting balls into cells: a ball takes a ticket, how many were counted into its cell before it. Which ball of a cell
// gets which ticket depends on who comes first; order_keys makes up for that.
#include "shared/used_tiles.glsl"

layout(std430, binding = SLOT_CELL_RANGES) buffer CellRangesBlock { CellRange cell_ranges[]; };
layout(std430, binding = BINDING_TICKETS) writeonly buffer TicketsBlock { uint tickets[]; };

void take_ticket(uint place, uint cell) {
    tickets[place] = atomicAdd(cell_ranges[cell].end, 1u);
    mark_tile(cell);
}
