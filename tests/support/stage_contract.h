// What every backend must do, stage by stage, against brute force and invariants. Mirror and GPU are held to
// the same lines.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/backend.h"

namespace ballpit::test {

/// Every count from 0 to two work groups, and the powers of two around which padding and tiles change, up to `largest`.
std::vector<std::uint32_t> interesting_counts(std::uint32_t largest);

void assigns_cells(Backend& backend, std::span<const std::uint32_t> counts);
void assigns_strange_points(Backend& backend);
void sorts_every_pattern(Backend& backend, SortMethod sort, std::span<const std::uint32_t> counts);
/// Counting: the ranges from the keys, then the keys sorted by the ranges.
void counts_and_sorts_every_pattern(Backend& backend, std::span<const std::uint32_t> counts);
void builds_the_grid(Backend& backend, std::span<const std::uint32_t> counts);
void refuses_keys_of_no_cell(Backend& backend);
void finds_every_pair(Backend& backend, std::span<const std::uint32_t> counts);
void collides_like_brute_force(Backend& backend, std::span<const std::uint32_t> counts);
void keeps_its_input(Backend& backend);
void parts_coincident_balls(Backend& backend);
void contains_a_ball_that_is_no_number(Backend& backend);

}  // namespace ballpit::test
