// Mirror of glsl/assign_cells.comp: every ball gets the id of the cell that its centre lies in.
#pragma once

#include <span>

#include "core/layout.h"
#include "core/substep_params.h"
#include "cpu/ball_range.h"

namespace ballpit::cpu {

/// Cell coordinates of a point (m). Points outside the box belong to the outermost cells, NaN to cell 0.
template <class Real>
uvec3 cell_coordinates(const SubstepParams<Real>& params, const Vec3<Real>& point);

/// keys[i] = (cell id, i) for each ball of a range, sentinels behind the last ball of all. Counts centres outside the
/// box. positions: ball_count; keys: key_count.
template <class Real>
void assign_cells(const SubstepParams<Real>& params, std::span<const Vec4<Real>> positions, std::span<Key> keys,
                  Status& status, BallRange balls);

/// The same where the order is kept: place i holds the ball that keys[i] names already; and each is counted into its
/// cell, as count_cells does it. kept_positions: ball_count, in the order of the keys.
template <class Real>
void assign_and_count(const SubstepParams<Real>& params, std::span<const Vec4<Real>> kept_positions,
                      std::span<Key> keys, std::span<CellRange> cell_ranges, std::span<std::uint32_t> used_tiles,
                      std::span<std::uint32_t> tickets, Status& status);

}  // namespace ballpit::cpu
