// How close balls lie, as collide meets them: what it has to look at, and what touches.
#pragma once

#include <cstdint>
#include <span>

#include "core/grid.h"
#include "core/vector.h"

namespace ballpit::measure {

struct Crowding {
    double candidates = 0.0;  // other balls in the 27 cells around a ball, on average
    double contacts = 0.0;    // of those, balls that touch it
};

/// Asks every ball where there are at most `most`, else as many evenly spread over the ids. O(n).
Crowding crowding_of(std::span<const vec4> positions, const Grid& grid, std::uint32_t most = 200000);

}  // namespace ballpit::measure
