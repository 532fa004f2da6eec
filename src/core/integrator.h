// Integrators, all with one force evaluation a substep, as kicks (velocity) and drifts (position).
//
// Leapfrog keeps the velocity half a substep behind the position. How far behind is part of the state
// (`velocity_lag`, s): 0 at the start, so the first kick is the initial half-kick, and a change of dt in
// the middle of a run stays second order. Velocity Verlet kicks twice, from the lag to the position's
// time and on to the half step; that is leapfrog's arithmetic, rounded twice.
#pragma once

#include <array>
#include <string_view>

namespace ballpit {

enum class Integrator { leapfrog, symplectic_euler, velocity_verlet, forward_euler, historical };

inline constexpr std::array<std::string_view, 5> integrator_names = {"leapfrog", "symplectic_euler", "velocity_verlet",
                                                                     "forward_euler", "historical"};

/// v becomes decay * v + gain * a. Exact for a constant over `duration` s and linear drag (1/s):
/// decay = exp(-drag * duration), gain = (1 - decay) / drag, which is `duration` without drag.
struct Kick {
    double decay = 1.0;
    double gain = 0.0;
    double decay_change = 0.0;  // decay - 1, accurate where decay is close to 1
};

Kick make_kick(double drag, double duration);

/// What one substep of `dt` s does: first kick, second kick (velocity Verlet only), drift time (s), and the
/// lag it leaves behind (s).
struct SubstepMotion {
    Kick first;
    Kick second;
    double drift = 0.0;
    double lag_after = 0.0;
};

SubstepMotion substep_motion(Integrator integrator, double drag, double dt, double velocity_lag);

/// Only the kick that brings the velocity to the position's time; nothing moves.
SubstepMotion synchronising_motion(double drag, double velocity_lag);

}  // namespace ballpit
