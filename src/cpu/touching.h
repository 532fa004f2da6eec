// The pairs of balls that touch, each found once, from copies of their positions in the order of the sorted keys: balls
// that are near each other are read in a row.
#pragma once

#include <span>
#include <vector>

#include "core/features.h"
#include "core/layout.h"
#include "core/substep_params.h"

namespace ballpit::cpu {

/// Centres (m) and radii (m) by slot, and some more places, so that the last ones can be read in a group.
struct SortedBalls {
    std::vector<float> x;
    std::vector<float> y;
    std::vector<float> z;
    std::vector<float> radius;

    void resize(std::size_t count);
    void put(std::uint32_t slot, const vec4& position, float ball_radius) {
        x[slot] = position.x;
        y[slot] = position.y;
        z[slot] = position.z;
        radius[slot] = ball_radius;
    }
};

/// Slots of two balls that touch, the lower one first.
struct TouchingPair {
    std::uint32_t first;
    std::uint32_t second;
};

/// Finds the pairs whose first slot is in [first, end), ascending by the first slot, then by the second: those that
/// collide finds in the 27 cells around each ball, by the same arithmetic. Returns how many; they stand at the start of
/// `pairs`, which grows as it must. keys: sorted, ball_count of them. cell_ranges: one a cell of the grid in `params`,
/// of these keys.
std::size_t find_touching(const SubstepParams<float>& params, std::span<const Key> keys,
                          std::span<const CellRange> cell_ranges, const SortedBalls& balls, std::uint32_t first,
                          std::uint32_t end, std::vector<TouchingPair>& pairs);

}  // namespace ballpit::cpu
