// Mirror of glsl/meter.comp and meter_sum.comp: what is metered of a moment, summed in double.
#pragma once

#include <span>

#include "core/features.h"
#include "core/layout.h"
#include "core/meter.h"
#include "core/substep_params.h"

namespace ballpit::cpu {

/// The state at the start of a substep, and what collide made of the velocities. Spans of laws that are absent may be
/// empty.
template <class Real>
struct MeterInput {
    std::span<const Vec4<Real>> positions;        // ball_count
    std::span<const Vec4<Real>> velocities;       // ball_count
    std::span<const Vec4<Real>> next_velocities;  // ball_count, or empty without the contact law
    std::span<const Real> damping_ratios;         // ball_count, or empty
    std::span<const Key> keys;                    // sorted, at least ball_count
    std::span<const CellRange> cell_ranges;       // cell_count
};

/// Which balls touch, and their overlaps, are found in Real and in collide's order of operations, so that none is
/// missed or added; everything that follows is double.
template <class Real>
MeterReading meter(const SubstepParams<Real>& params, Features features, const Synchronisation& synchronisation,
                   const MeterInput<Real>& in);

}  // namespace ballpit::cpu
