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
};

/// Every combination of the lists. Where none is given: four integrators over a ladder of substeps, and leapfrog's once
/// more with compensated sums. The ladder goes on to 65536 for a handful of balls, far enough to see rounding take
/// over, and to 128 for more.
std::vector<SweepPoint> sweep_points(const Settings& settings, const SweepLists& lists);

}  // namespace ballpit::measure
