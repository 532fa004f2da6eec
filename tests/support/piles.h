// Settled piles at the edge of stability: what the gauge of dt / dt_c is held to.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/simulation.h"

namespace ballpit::test {

/// Balls that rest on each other: what moves is what rounding moves, 1e-9 of weight_energy.
struct SettledPile {
    Scene scene;
    BallState state;
    double weight_energy = 0.0;  // J, sum of m g r: what lifts each ball by its radius
};

/// `balls` of 0.05 m and 1 kg, or of 0.025 to 0.05 m and 0.125 to 1 kg, at rest under gravity in float; no law takes
/// energy from here on.
SettledPile settled_pile(bool unequal_radii, std::uint32_t balls);

/// The same with dashpots of this restitution; 1: without.
SettledPile with_restitution(SettledPile pile, double restitution);

/// The same, each ball pushed in a direction of its own, so that the kinetic energy is this share of weight_energy.
SettledPile kicked(SettledPile pile, double share);

/// s: beyond it leapfrog's fastest mode of the contacts as they are grows, dashpots included. Where M - dt C / 2 -
/// dt^2 K / 4 is no longer positive, by power iteration in double.
double true_critical_dt(const SettledPile& pile);

/// What the meters read of it.
MeterReading reading_of(const SettledPile& pile);

/// s: what the gauge has for dt_c.
double gauge_critical_dt(const SettledPile& pile);

/// s: half a period of two of the lightest balls.
double shortest_contact(const SettledPile& pile);

/// Both over weight_energy.
struct Course {
    double agitation = 0.0;  // the largest kinetic energy so far, looked at after every fifth substep; infinite where a
                             // ball is not finite
    double gain = 0.0;       // of kinetic, potential and elastic energy together, since the start
};

/// What is left after each of marks[i] substeps of `dt`; `marks` ascend.
std::vector<Course> course_of(const SettledPile& pile, double dt, std::span<const int> marks);
double agitation(const SettledPile& pile, double dt, int substeps);

}  // namespace ballpit::test
