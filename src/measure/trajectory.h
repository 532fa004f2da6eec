// Where the balls of a scene ought to be: a run in double with small substeps, and how long such a comparison means
// anything. Collisions multiply every difference, so after a while two runs that began one rounding apart are as far
// from each other as any two: up to there an error is an error, beyond only what can be averaged counts.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/ball_state.h"
#include "core/vector.h"

namespace ballpit::measure {

/// Positions (m) after each step, the start first, rounded to float.
using Trajectory = std::vector<std::vector<vec4>>;

/// m: root of the mean square distance of the same ball in both; infinite where a position is not finite. Expects as
/// many balls in both; 0 without balls.
double rms_distance(std::span<const vec4> a, std::span<const vec4> b);

struct Reference {
    std::string note;            // why there is none; else empty
    std::uint32_t substeps = 0;  // a step
    double substeps_a_contact = 0.0;
    double diameter = 0.0;             // m, mean over the balls
    Trajectory positions;              // as far as it has come
    std::vector<double> twin_at;       // m, rms: how far a twin is after each step that began one rounding off
    std::optional<std::size_t> steps;  // the horizon: after so many the twin is still near; known when the twin is done

    bool usable() const { return note.empty() && steps.has_value(); }
};

/// Steps after which the twin is still nearer than a tenth of a diameter.
std::size_t horizon_of(std::span<const double> twin_at, double diameter);

/// The state with every position moved by one rounding of float, this way or that by the number of the ball.
BallState moved_by_a_rounding(BallState state);

}  // namespace ballpit::measure
