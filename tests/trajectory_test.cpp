// How far two runs are from each other, and how long that says anything.
#include "measure/trajectory.h"

#include <limits>

#include "support/catch.h"

using namespace ballpit;
using measure::horizon_of;
using measure::rms_distance;

TEST_CASE("the distance of two runs is the root of the mean square over the balls", "[trajectory]") {
    const std::vector<vec4> a = {{0, 0, 0, 1}, {1, 1, 1, 1}};
    const std::vector<vec4> b = {{3, 4, 0, 2}, {1, 1, 1, 1}};  // radii are none of it
    CHECK(rms_distance(a, b) == Approx(5.0 / std::sqrt(2.0)));
    CHECK(rms_distance({}, {}) == 0.0);
    const std::vector<vec4> gone = {{0, 0, 0, 1}, {std::numeric_limits<float>::quiet_NaN(), 1, 1, 1}};
    CHECK(rms_distance(a, gone) == std::numeric_limits<double>::infinity());
}

TEST_CASE("the horizon is the last step at which the twin is within a tenth of a diameter", "[trajectory]") {
    const std::vector<double> growing = {1e-7, 1e-5, 0.019, 0.021, 0.001};
    CHECK(horizon_of(growing, 0.2) == 2);
    CHECK(horizon_of(growing, 10.0) == 4);
    CHECK(horizon_of(growing, 1e-9) == 0);
}

TEST_CASE("a twin begins one rounding away in every coordinate, and nowhere else", "[trajectory]") {
    BallState state;
    state.positions = {{1.0f, -2.0f, 0.0f, 0.5f}, {0.0f, 3.0f, -4.0f, 0.25f}};
    state.velocities = {{1, 2, 3, 4}, {5, 6, 7, 8}};
    const BallState moved = measure::moved_by_a_rounding(state);
    CHECK(moved.velocities == state.velocities);
    for (std::size_t i = 0; i < 2; ++i) {
        CHECK(moved.positions[i].w == state.positions[i].w);
        for (int axis = 0; axis < 3; ++axis) {
            const float x = state.positions[i][axis];
            const float size = x == 0.0f ? state.positions[i].w : std::abs(x);
            const float step = std::abs(moved.positions[i][axis] - x);
            CHECK(step > 0.0f);
            CHECK(step <= size * std::numeric_limits<float>::epsilon());
        }
    }
}
