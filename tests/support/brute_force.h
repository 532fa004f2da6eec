// One substep in double by comparing every ball with every other: the yardstick for collide. Written from the
// contact law, not from the stages.
#pragma once

#include <vector>

#include "core/ball_state.h"
#include "core/features.h"
#include "core/settings.h"

namespace ballpit::test {

struct ExpectedBall {
    dvec3 position{0.0};
    dvec3 velocity{0.0};
    double force_scale = 0.0;  // N: sum of the magnitudes of the contact forces, spring and dashpot apart
    int contacts = 0;
    bool coincident = false;  // with another ball: the direction is a matter of definition, and not expected here
};

/// `dt` is the substep; the velocity of leapfrog and velocity Verlet lags by nothing before it.
std::vector<ExpectedBall> brute_force_substep(const BallState& state, Features features, const Settings& settings,
                                              const dvec3& half_extent, double dt);

}  // namespace ballpit::test
