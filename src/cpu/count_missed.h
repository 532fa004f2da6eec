// Mirror of glsl/count_missed.comp: what a grid that is used by several substeps would not show any more.
#pragma once

#include <span>

#include "core/features.h"
#include "core/layout.h"
#include "core/substep_params.h"

namespace ballpit::cpu {

/// For each ball, the balls that touch it now and that collide would not have found from here in the cells where they
/// were at the build before: counted in status.missed. status.drift_bits keeps the largest square (m^2) of a ball's way
/// since then, as a float's bits. positions, built_positions: ball_count each; keys (sorted) and cell_ranges: of the
/// new grid, which has the cells of the one before.
template <class Real>
void count_missed(const SubstepParams<Real>& params, Features features, std::span<const Vec4<Real>> positions,
                  std::span<const Vec4<Real>> built_positions, std::span<const Key> keys,
                  std::span<const CellRange> cell_ranges, Status& status);

}  // namespace ballpit::cpu
