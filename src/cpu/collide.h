// Mirror of glsl/collide.comp: contact forces of the neighbours and walls, gravity, drag, and the integrator.
#pragma once

#include <span>

#include "core/features.h"
#include "core/layout.h"
#include "core/substep_params.h"

namespace ballpit::cpu {

/// What collide reads. Spans of laws that are absent may be empty.
template <class Real>
struct CollideInput {
    std::span<const Vec4<Real>> positions;   // ball_count
    std::span<const Vec4<Real>> velocities;  // ball_count
    std::span<const Real> damping_ratios;    // ball_count, or empty
    std::span<const Key> keys;               // sorted, at least ball_count
    std::span<const CellRange> cell_ranges;  // cell_count
};

/// Writes the next state of each ball, which may be over the state that is read where the contact law is absent;
/// counts those that are not finite, with diagnostics. Neighbours are met in the order of
/// cells and slots, so the sums, and with them the bits of the result, do not depend on who runs when.
template <class Real>
void collide(const SubstepParams<Real>& params, Features features, const CollideInput<Real>& in,
             std::span<Vec4<Real>> next_positions, std::span<Vec4<Real>> next_velocities, Status& status);

}  // namespace ballpit::cpu
