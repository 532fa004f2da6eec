// The starting state of a scene, as a pure function of scene, count and seed.
#pragma once

#include "core/ball_state.h"
#include "core/features.h"
#include "core/scene.h"

namespace ballpit {

struct World {
    BallState balls;
    Box box;
    std::uint32_t overlapping = 0;  // balls of the fill that found no free place
};

/// The restitution of each ball: its own, else the scene's as it is set now. Empty where no ball has its own and the
/// law is not asked for.
std::vector<double> ball_restitutions(const Scene& scene, const Settings& settings, std::uint32_t count);

/// In what these balls differ.
Variety variety_of(const BallState& balls);

/// m; 0 without balls.
double largest_radius(const BallState& balls);

/// kg, of a ball of this radius (m) and density (kg/m^3).
double sphere_mass(double radius, double density);

/// Appends a ball; values are rounded to single, what that leaves out is its compensation. Restitutions are those of
/// ball_restitutions.
void add_ball(BallState& balls, const BallSpec& spec);

/// The first `scene.settings.balls`-like count of balls: those listed first, then the fill, which goes on as
/// long as `count` asks for more (the fill's own count is only the default). Ball i is the same for every
/// count at which the box is as wide. Throws InputError if more balls are asked for than the scene can
/// give (no fill).
World make_world(const Scene& scene, std::uint32_t count, std::uint64_t seed);

}  // namespace ballpit
