// The balance of momentum over one substep: contacts between balls cancel, so what changes it comes from outside.
#pragma once

#include <span>

#include "core/features.h"
#include "core/substep_params.h"
#include "measure/invariants.h"

namespace ballpit::measure {

/// collide: the momentum after the substep is the one before, drag taken off, plus gravity's and the walls' impulse.
/// Summed in double from the state that collide read; the tolerance is what rounding explains (float_bound.h).
/// States that are not finite are no matter of this invariant.
Violation momentum_balanced(const SubstepParams<double>& params, Features features, std::span<const vec4> positions,
                            std::span<const vec4> velocities, std::span<const float> damping_ratios,
                            std::span<const vec4> next_velocities, std::span<const Compensation> compensations = {});

}  // namespace ballpit::measure
