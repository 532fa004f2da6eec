// A grid that several substeps use. It still shows a ball to those around it as long as no ball has gone farther than
// the skin: what a cell is wider than the largest diameter.
#pragma once

#include "core/grid.h"
#include "core/layout.h"

namespace ballpit {

/// m: how far a ball may go after the grid was built. A ball looks for others from where it is, and finds them in the
/// cells where they were: 27 cells reach one cell width around it, so a pair in touch, at most one diameter apart, is
/// missed only if the other one has gone farther than cell width - diameter.
double skin(const Grid& grid, double largest_radius);

/// m: the longest way of a ball from one build to the next, since the counters were cleared. The last substep that used
/// a grid came before all of that way was gone, so this errs on the safe side.
double drift(const Status& status);

/// The cell factor whose skin holds a quarter more than this way (m), rounded up to hundredths.
double cell_factor_for(double drift, double largest_radius);

}  // namespace ballpit
