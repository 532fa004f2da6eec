// What is metered of a moment: energies, where energy goes, momentum, overlaps, and how stiffly the balls are held.
// A pass beside the substep, no part of the physics: it is asked for, read late, and changes nothing.
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <utility>
#include <vector>

#include "core/integrator.h"
#include "core/vector.h"

namespace ballpit {

/// Sums over all balls, and the largest of any, at the start of a substep; velocities at the time of the positions.
/// Pairs that touch are counted once. Heat is what the force of a contact, as collide applies it, takes away beyond
/// what its spring k gives back: (k overlap - F) times the speed of separation.
struct MeterReading {
    double kinetic = 0.0;            // J
    double potential = 0.0;          // J, zero at the origin
    double elastic = 0.0;            // J, k overlap^2 / 2 of every contact, walls included
    double contact_heat = 0.0;       // W, of balls with balls
    double wall_heat = 0.0;          // W, of balls with walls
    double wall_work = 0.0;          // W, that moving walls put in: force times velocity of the wall
    double hand_work = 0.0;          // W, that the hand puts in
    dvec3 momentum{0.0};             // kg m/s
    dvec3 angular_momentum{0.0};     // kg m^2/s, about the centre of the box
    double overlap_shares = 0.0;     // sum over contacts: overlap / sum of radii, or diameter at a wall
    double contact_ends = 0.0;       // twice the pairs that touch
    double wall_contacts = 0.0;      // balls at a wall, each wall counted
    double floor_force = 0.0;        // N, of the lower wall along z
    double mass = 0.0;               // kg
    double max_overlap = 0.0;        // m
    double max_overlap_share = 0.0;  // of the sum of radii, or of the diameter at a wall
    double max_speed = 0.0;          // m/s
    /// 1/s^2: largest eigenvalue of the sum of 2 k n n^T over a ball's balls and k n n^T over its walls, over its mass.
    double max_stiffness = 0.0;
    double max_speed_share = 0.0;  // 1/s, speed over diameter
    double max_lightness = 0.0;    // 1/kg, of the lightest ball
    /// 1/s: the same with the dashpots c in place of k.
    double max_damping = 0.0;

    double contacts() const { return 0.5 * contact_ends + wall_contacts; }
    /// 0 without contacts.
    double mean_overlap_share() const { return contacts() > 0.0 ? overlap_shares / contacts() : 0.0; }
    double energy() const { return kinetic + potential + elastic; }
};

/// From METER_VALUES numbers in the order of layout.h.
MeterReading reading_of(std::span<const double> values);

struct TaggedReading {
    std::uint64_t tag = 0;
    MeterReading reading;
};

/// A reading and the moment that it is of.
struct MeterRecord {
    std::uint64_t step = 0;
    std::uint32_t substep = 0;
    double time = 0.0;  // s
    double dt = 0.0;    // s, of the substep that begins here
    double drag = 0.0;  // 1/s
    dvec3 gravity{0.0};
    /// Records of one run that nothing interrupted have the same number: not across a step back, another scene, or a
    /// change that moves energy or hands it to another integrator.
    std::uint64_t run = 0;
    MeterReading reading;

    /// W, lost to drag: its force is drag * m * v.
    double drag_heat() const { return 2.0 * drag * reading.kinetic; }
    double weight() const { return reading.mass * glm::length(gravity); }
};

/// Moments whose readings have been asked for, and not arrived yet.
class MeterQueue {
public:
    /// The tag to ask with.
    std::uint64_t add(const MeterRecord& moment);
    /// Records whose readings have arrived, in the order of time. Moments whose readings are lost are dropped.
    std::vector<MeterRecord> match(std::span<const TaggedReading> readings);
    void clear() { waiting_.clear(); }

private:
    std::uint64_t next_tag_ = 0;
    std::deque<std::pair<std::uint64_t, MeterRecord>> waiting_;
};

/// A velocity at the time of the positions is old_velocity * v + new_velocity * v' + acceleration * a, where v' is what
/// this substep makes of v, and a what it accelerates with.
struct Synchronisation {
    double old_velocity = 1.0;
    double new_velocity = 0.0;
    double acceleration = 0.0;  // s
};

/// Exactly what a kick over the lag (s) with this drag (1/s) would do, by v' where balls touch each other and by a in
/// place, where v' is not there yet.
Synchronisation synchronisation_of(const SubstepMotion& motion, double drag, double velocity_lag, bool in_place);

}  // namespace ballpit
