// Which balls touch, found without the stages: the yardstick for the grid.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/vector.h"

namespace ballpit::measure {

/// Balls a < b whose spheres overlap.
struct Pair {
    std::uint32_t a;
    std::uint32_t b;
    friend bool operator==(const Pair&, const Pair&) = default;
    friend auto operator<=>(const Pair&, const Pair&) = default;
};

/// The contact test of the collide stage, in float and in its order of operations; false for NaN.
bool touching(const vec4& a, const vec4& b);

/// All touching pairs, ascending, by comparing every ball with every other: O(n^2).
std::vector<Pair> brute_force_pairs(std::span<const vec4> positions);

/// The same set in O(n log n), by sorting balls into cells of the largest diameter.
std::vector<Pair> touching_pairs(std::span<const vec4> positions);

}  // namespace ballpit::measure
