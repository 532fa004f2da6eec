// Lets the balls of a scene come to rest, so that a pile can be measured rather than a fall.
#pragma once

#include <cstdint>

#include "core/simulation.h"

namespace ballpit::app {

/// The scene with the fill in the lowest part of its region, as densely as it can be put at random: what would fall
/// for seconds has only its last bit to go. The same where the balls fill that part anyway.
Scene lowered(const Scene& scene, std::uint32_t balls);

struct Settling {
    std::uint64_t steps = 0;
    double seconds = 0.0;  // of the wall clock
    double kinetic = 0.0;  // a ball's mean kinetic energy in the end, over its weight times its radius
    bool at_rest = false;  // that is below `at_rest_below`
};

inline constexpr double at_rest_below = 0.005;

/// Runs until the balls are at rest, or for so many seconds of the wall clock. Throws InputError where there is no
/// gravity to make them settle.
Settling settle(Simulation& simulation, double limit_s);

}  // namespace ballpit::app
