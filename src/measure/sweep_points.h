// Which choices a sweep compares.
#pragma once

#include <vector>

#include "measure/sweep.h"

namespace ballpit::measure {

/// What was asked for; an empty list leaves the choice to the sweep.
struct SweepLists {
    std::vector<Integrator> integrators;
    std::vector<std::uint32_t> substeps;
    std::vector<bool> compensated;
    std::vector<std::uint32_t> grid_reuse;
};

/// Every combination of the lists; what is not in a list is as in the settings. Where no list but that of substeps is
/// given: four integrators over a ladder of substeps, and leapfrog's twice more, with compensated sums and, where there
/// is a grid, with one grid for eight substeps. The ladder goes on to 65536 for a handful of balls, far enough to see
/// rounding take over, and to 128 for more.
std::vector<SweepPoint> sweep_points(const Settings& settings, const SweepLists& lists);

}  // namespace ballpit::measure
