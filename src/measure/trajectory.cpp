#include "measure/trajectory.h"

#include <cassert>
#include <cmath>
#include <limits>

namespace ballpit::measure {

namespace {

constexpr double near_share = 0.1;  // of a diameter

}  // namespace

double rms_distance(std::span<const vec4> a, std::span<const vec4> b) {
    assert(a.size() == b.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const dvec3 offset = dvec3(a[i]) - dvec3(b[i]);
        sum += glm::dot(offset, offset);
    }
    if (!std::isfinite(sum)) {
        return std::numeric_limits<double>::infinity();
    }
    return a.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(a.size()));
}

std::size_t horizon_of(std::span<const double> twin_at, double diameter) {
    std::size_t steps = 0;
    while (steps < twin_at.size() && twin_at[steps] < near_share * diameter) {
        ++steps;
    }
    return steps == 0 ? 0 : steps - 1;
}

BallState moved_by_a_rounding(BallState state) {
    for (std::size_t i = 0; i < state.positions.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            const bool up = (i + static_cast<std::size_t>(axis)) % 2 == 0;
            const float end = up ? std::numeric_limits<float>::max() : std::numeric_limits<float>::lowest();
            // A coordinate of 0 moves by what its neighbours at the ball's radius would.
            float& x = state.positions[i][axis];
            x = x == 0.0f ? std::nextafter(state.positions[i].w, end) - state.positions[i].w : std::nextafter(x, end);
        }
    }
    return state;
}

}  // namespace ballpit::measure
