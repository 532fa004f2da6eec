// How far the floats of collide may lie from the mirror's on a device whose division and square root are not
// correctly rounded. docs/accuracy.md derives the bound.
#pragma once

#include <span>
#include <vector>

#include "core/features.h"
#include "core/substep_params.h"

namespace ballpit::measure {

struct CollideBound {
    std::vector<double> position;  // m, one a ball
    std::vector<double> velocity;  // m/s, one a ball
};

/// From the state before the substep (positions and velocities as in the slots; damping_ratios may be empty).
CollideBound collide_bound(const SubstepParams<double>& params, Features features, std::span<const vec4> positions,
                           std::span<const vec4> velocities, std::span<const float> damping_ratios);

}  // namespace ballpit::measure
