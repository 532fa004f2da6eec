// Mirror of glsl/collide.comp: contact forces of the neighbours and walls, gravity, drag, and the integrator.
#pragma once

#include <span>

#include "core/features.h"
#include "core/layout.h"
#include "core/substep_params.h"
#include "cpu/ball_range.h"

namespace ballpit::cpu {

/// What rounding has left out of a ball's position (m) and velocity (m/s).
template <class Real>
struct LeftOut {
    Vec3<Real> position{0};
    Vec3<Real> velocity{0};
};

/// What collide reads. Spans of laws that are absent may be empty.
template <class Real>
struct CollideInput {
    std::span<const Vec4<Real>> positions;   // ball_count
    std::span<const Vec4<Real>> velocities;  // ball_count
    std::span<const Real> damping_ratios;    // ball_count, or empty
    std::span<const Key> keys;               // sorted, at least ball_count
    std::span<const CellRange> cell_ranges;  // cell_count
};

/// Where collide writes: over the state that is read where the contact law is absent.
template <class Real>
struct CollideOutput {
    std::span<Vec4<Real>> next_positions;   // ball_count
    std::span<Vec4<Real>> next_velocities;  // ball_count
    std::span<LeftOut<Real>> left_out;      // ball_count where sums are compensated, else empty
};

/// Writes the next state of the balls of a range; counts those that are not finite, with diagnostics. Neighbours are
/// met in the order of cells and slots, so the sums, and with them the bits of the result, do not depend on who runs
/// when, nor on how the balls are shared out.
template <class Real>
void collide(const SubstepParams<Real>& params, Features features, const CollideInput<Real>& in,
             const CollideOutput<Real>& out, Status& status, BallRange balls);

}  // namespace ballpit::cpu
