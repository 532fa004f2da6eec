// The balls of a collision probe and the substep that moves them: pure functions of the question.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/ball_state.h"
#include "core/schedule.h"
#include "core/substep_params.h"
#include "measure/probe_scene.h"

namespace ballpit::measure {

/// What is to be probed: these settings (step, substeps, integrator, stiffness and laws may be any) in this scene.
struct ProbeQuestion {
    Settings settings;
    ProbeScene scene;
};

inline constexpr std::uint32_t probe_phases = 64;
/// Contacts that last longer are not run.
inline constexpr std::uint32_t most_probe_substeps = 16384;

/// One of them. A ball, and the one that it meets; without one, it meets the wall.
struct ProbedCollision {
    std::uint32_t ball = 0;
    bool wall = false;
    double speed = 0.0;  // m/s, of approach
    double reach = 0.0;  // m, distance from the wall, or between the centres, at which they touch
};

struct ProbeCollisions {
    std::string nothing;  // why there is nothing to probe; else empty
    Schedule schedule;
    BallState balls;
    double wall = 0.0;                        // m, x of the wall
    std::vector<ProbedCollision> collisions;  // groups of probe_phases
    std::uint32_t substeps = 0;               // until all should be over
    double damping_ratio = 0.0;               // zeta, as the program has it
};

ProbeCollisions make_probe_collisions(const ProbeQuestion& question);

/// The constants of a substep. Laws that would disturb stay compiled in, with nothing to do: no gravity, no drag, no
/// hand, walls at rest. (That a coefficient of zero changes no bit is a test of every law.)
SubstepParams<double> probe_params(const ProbeQuestion& question, const ProbeCollisions& collisions,
                                   double velocity_lag);

/// rad/s, of a contact of the lightest balls: two of them, or one and a wall.
double contact_frequency(const ProbeQuestion& question, bool wall);

}  // namespace ballpit::measure
