// What a dispatch did, in numbers, read from the buffers that it has just left behind.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <variant>

#include "core/box.h"
#include "core/layout.h"
#include "core/schedule.h"
#include "core/vector.h"

namespace ballpit::measure {

struct AssignNumbers {
    std::uint32_t balls = 0;
    std::uint32_t cells = 0;     // of the grid
    std::uint32_t occupied = 0;  // cells that a key names
    std::uint32_t padding = 0;   // keys that are sentinels
    std::uint32_t outside = 0;   // balls whose centre is outside the box
};
struct SortNumbers {
    std::uint32_t pass = 0;  // from 1
    std::uint32_t passes = 0;
    std::uint32_t k = 0;
    std::uint32_t j = 0;
    std::uint32_t pairs = 0;
    std::optional<std::uint32_t> swapped;  // unknown without the keys before
};
struct ClearNumbers {
    std::uint32_t cells = 0;
};
struct BuildNumbers {
    std::uint32_t occupied = 0;
    std::uint32_t cells = 0;
    std::uint32_t fullest = 0;  // a cell id
    std::uint32_t most = 0;     // balls in it
};
struct CollideNumbers {
    std::optional<std::uint32_t> contacts;  // of two balls; not counted where that would take long
    float largest_overlap = 0.0f;           // m, among them
    std::optional<std::uint32_t> fastest;   // a ball; none where no speed is a number
    float top_speed = 0.0f;                 // m/s
    std::uint32_t not_finite = 0;           // balls whose new state is no number
};

using StageNumbers =
    std::variant<std::monostate, AssignNumbers, SortNumbers, ClearNumbers, BuildNumbers, CollideNumbers>;

/// Balls count as outside where the shader counts them so: `box`, rounded to single.
AssignNumbers assign_numbers(const Schedule& schedule, std::span<const Key> keys, std::span<const vec4> positions,
                             const Box& box);
/// `before` may be empty.
SortNumbers sort_numbers(const Schedule& schedule, const Dispatch& pass, std::span<const Key> before);
BuildNumbers build_numbers(std::span<const CellRange> cell_ranges);

/// More balls than this are not asked for their contacts.
inline constexpr std::size_t most_balls_for_contacts = 200000;

/// `positions`: that collide has read; `new_velocities`: that it has written.
CollideNumbers collide_numbers(std::span<const vec4> positions, std::span<const vec4> new_velocities);

}  // namespace ballpit::measure
