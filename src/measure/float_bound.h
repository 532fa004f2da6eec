// How far the floats of collide may lie from the mirror's on a device whose division and square root are not
// correctly rounded. docs/accuracy.md derives the bound.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/features.h"
#include "core/substep_params.h"

namespace ballpit::measure {

struct CollideBound {
    std::vector<double> position;      // m, one a ball
    std::vector<double> velocity;      // m/s, one a ball
    std::vector<double> compensation;  // m and m/s alike, the larger of the two; empty where none is kept
};

/// From the state before the substep (positions and velocities as in the slots; damping_ratios and compensations may be
/// empty).
CollideBound collide_bound(const SubstepParams<double>& params, Features features, std::span<const vec4> positions,
                           std::span<const vec4> velocities, std::span<const float> damping_ratios,
                           std::span<const Compensation> compensations = {});

/// Overlap (m) of a ball with the lower and the upper wall along an axis, in float and in the order of the stage,
/// because whether a ball just touches must not be a matter of rounding. `left_out`: of its position.
std::array<double, 2> wall_overlaps(const SubstepParams<double>& params, const vec4& position, int axis,
                                    const Compensation& left_out);

}  // namespace ballpit::measure
