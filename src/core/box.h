// The box, and its walls in motion.
#pragma once

#include "core/settings.h"
#include "core/vector.h"

namespace ballpit {

struct Box {
    dvec3 lower{0.0};  // m
    dvec3 upper{0.0};

    Box() = default;
    Box(const dvec3& lower_corner, const dvec3& upper_corner) : lower(lower_corner), upper(upper_corner) {}
    /// Centred on the origin.
    Box(const dvec3& half_extent) : lower(-half_extent), upper(half_extent) {}

    dvec3 size() const { return upper - lower; }
    /// Of the smallest box around the origin that holds this one.
    dvec3 half_extent() const { return glm::max(glm::abs(lower), glm::abs(upper)); }
    friend bool operator==(const Box&, const Box&) = default;
};

/// The smallest box that holds both.
Box united(const Box& a, const Box& b);

/// How far the walls have come from where the scene has them; part of the state of a run.
struct WallShift {
    dvec3 low{0.0};           // m, lower walls
    dvec3 high{0.0};          // m, upper walls
    dvec3 shake{0.0};         // m, the whole box
    double shake_phase{0.0};  // rad
    friend bool operator==(const WallShift&, const WallShift&) = default;
};

/// The walls during one substep.
struct Walls {
    Box box;
    dvec3 lower_velocity{0.0};  // m/s
    dvec3 upper_velocity{0.0};

    Walls(const Box& still) : box(still) {}
    Walls(const dvec3& half_extent) : box(half_extent) {}
    Walls(const Box& now, const dvec3& lower, const dvec3& upper)
        : box(now), lower_velocity(lower), upper_velocity(upper) {}
};

/// Where the walls of `scene_box` stand.
Box shifted(const Box& scene_box, const WallShift& shift);

/// `dt` s later: walls go to walls_low and walls_high at wall_speed, but never nearer to each other than `room` (m);
/// a shaken box follows amplitude * sin(phase), counted from where it is.
WallShift advance(const WallShift& shift, const Settings& settings, const Box& scene_box, double room, double dt);

/// Whether another `advance` will move them.
bool walls_move(const WallShift& shift, const Settings& settings, const Box& scene_box, double room);

/// The walls on their way from one to the other; still where dt is 0.
Walls moving_walls(const Box& scene_box, const WallShift& from, const WallShift& to, double dt);

}  // namespace ballpit
