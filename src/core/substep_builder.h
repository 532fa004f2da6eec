// The parts of a substep, each appended to the list of a schedule. What the schedule says of itself (balls, keys,
// cells, features, whether it keeps the order) has to be there before.
#pragma once

#include "core/schedule.h"

namespace ballpit {

/// Whether balls find each other through cells.
bool needs_grid(Features features);

/// assign_cells, the sort, and the table of cells.
void add_neighbour_grid(Schedule& schedule, SortMethod sort);
/// The same by counting, with the state wherever the substep before left it: assign_cells counts, too, and order_keys
/// takes the state along.
void add_grid_in_kept_order(Schedule& schedule);
/// What tells contacts that a grid used by several substeps does not show, before the first look.
void add_count_missed(Schedule& schedule);
void add_gather(Schedule& schedule);
void add_collide(Schedule& schedule);

}  // namespace ballpit
