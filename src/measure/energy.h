// Sums over a state, in double: energies, momentum, overlaps.
#pragma once

#include "core/ball_state.h"
#include "core/box.h"
#include "core/features.h"
#include "core/settings.h"

namespace ballpit::measure {

struct Totals {
    double kinetic = 0.0;        // J
    double potential = 0.0;      // J, zero at the height of the box's centre
    double elastic = 0.0;        // J, k * overlap^2 / 2 of every contact, walls included
    dvec3 momentum{0.0};         // kg m/s
    double max_overlap = 0.0;    // m, of two balls or of a ball and a wall
    std::uint32_t contacts = 0;  // pairs of balls that touch
};

/// `state` must have velocities at the time of the positions (Simulation::synchronised_state). Laws that the
/// scene does not have contribute nothing.
Totals totals_of(const BallState& state, const Settings& settings, Features features, const Box& box);

}  // namespace ballpit::measure
