// What a probe of single collisions has to know of a scene, beside its settings: how large, how heavy, how fast, how
// far from the origin, how crowded. One pass over the balls.
#pragma once

#include <cstdint>

#include "core/ball_state.h"
#include "core/box.h"
#include "core/features.h"
#include "core/settings.h"

namespace ballpit::measure {

struct ProbeScene {
    Variety variety;
    bool walls_move = false;
    double distance = 0.0;          // m, of the farthest wall from the origin: there a float coordinate is coarsest
    double radius = 0.0;            // m, of the smallest ball
    double mass = 1.0;              // kg, of the lightest
    double restitution = 1.0;       // the smallest of all balls; 1 without the law
    double typical_speed = 0.0;     // m/s
    double largest_speed = 0.0;     // m/s
    bool speed_is_assumed = false;  // nothing moves and nothing falls
    double pair_rate = 0.0;         // 1/s, collisions of one ball with others
    double wall_rate = 0.0;         // 1/s, of one ball with the walls
};

/// Speeds are those that the balls have or can fall to, since a budget that is chosen now is to hold a moment later:
/// the largest is sqrt(v^2 + 2 g h) of the ball for which it is largest, h its height above the wall that it falls
/// towards; the typical one is the root of the mean of v^2 + g h. Without losses collisions spread speeds as Maxwell
/// has it, and the largest is at least sqrt(2/3 ln N) typical ones. Drag limits both to what falling can reach, walls
/// that move add their speed. Overlaps of more than a tenth of a diameter fly apart: half of what each of their springs
/// holds goes to either ball. Where nothing moves or falls, a speed is assumed that presses two of the smallest balls
/// into each other by a hundredth of their diameter.
///
/// Rates are those of a gas of hard spheres with this typical speed, in the smallest upright box that holds the balls
/// (kinetic theory; contact value of Carnahan and Starling): 4 n d^2 chi sqrt(pi kT/m) and, for all six walls of the
/// scene's box, a quarter of the mean speed times area by volume.
///
/// `restitutions` of the state may be empty: then the settings' holds where its law does.
ProbeScene probe_scene(const BallState& state, const Settings& settings, const Box& box, const Variety& variety,
                       bool walls_move = false);

}  // namespace ballpit::measure
