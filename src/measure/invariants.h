// What each stage promises to leave behind, as functions that tests, `ballpit check` and the window share.
// Each gives the first place where the promise is broken, in words, or nothing.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "core/layout.h"
#include "core/vector.h"

namespace ballpit::measure {

using Violation = std::optional<std::string>;

/// assign_cells: key i is ball i in an existing cell for i < ball_count, a sentinel behind.
Violation keys_assigned(std::span<const Key> keys, std::uint32_t ball_count, std::uint32_t cell_count);

/// bitonic_sort: ascending, and every ball id of [0, ball_count) once, sentinels last.
Violation keys_sorted(std::span<const Key> keys, std::uint32_t ball_count);

/// build_grid: the ranges of the cells partition the slots [0, ball_count), and each holds its cell's keys.
Violation ranges_partition(std::span<const CellRange> cell_ranges, std::span<const Key> keys, std::uint32_t ball_count);

/// collide: no NaN and no infinity.
Violation all_finite(std::span<const vec4> positions, std::span<const vec4> velocities);

}  // namespace ballpit::measure
