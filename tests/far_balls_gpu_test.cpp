// Many balls from afar look as the ray-cast ones do, where they are.
#include <cmath>
#include <cstdlib>

#include "support/catch.h"
#include "support/gl_fixture.h"
#include "support/studio.h"
#include "view/far_balls.h"

using namespace ballpit;
using namespace ballpit::test;

namespace {

// Balls scattered over a plane that faces the eye, none before another, and as many nowhere as it takes to be many.
std::vector<vec4> sparse_field(float radius, std::uint32_t count) {
    constexpr int across = 20;
    std::vector<vec4> balls(count, vec4(not_a_number));
    for (int i = 0; i < across * across; ++i) {
        const auto jitter = static_cast<float>(i * 7 % 11) / 300.0f;
        const int column = i % across;
        const int row = i / across;
        const float x = 0.09f * static_cast<float>(column) - 0.85f + jitter;
        const float z = 0.09f * static_cast<float>(row) - 0.85f - jitter;
        balls[static_cast<std::size_t>(i)] = vec4(x, 0.0f, z, radius);
    }
    return balls;
}

double difference(const Pixels& a, const Pixels& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i]));
    }
    return sum;
}

}  // namespace

TEST_CASE_METHOD(GlFixture, "balls of a few pixels are from afar as large and as bright as they are by ray", "[view]") {
    for (const bool computes : {true, false}) {
        for (const float radius : {0.006f, 0.01f, 0.02f}) {
            Studio studio(computes);
            studio.picture.show_shadows = false;
            studio.picture.look = Look::impostor;
            studio.picture.ball_colour = BallColour::plain;
            studio.picture.grid.cell_width = static_cast<double>(2.0f * radius);
            studio.set_balls({});
            const Pixels none = studio.draw();
            studio.set_balls(sparse_field(radius, far_from - 1));
            CHECK_FALSE(all_far(studio.picture));
            const Pixels rays = studio.draw();
            studio.set_balls(sparse_field(radius, far_from));
            CHECK(all_far(studio.picture));
            const Pixels points = studio.draw();
            CAPTURE(computes, radius, largest_across(studio.picture), difference(rays, none), difference(points, none));
            CHECK(difference(rays, none) > 50000.0);
            CHECK(difference(points, none) == Approx(difference(rays, none)).epsilon(0.25));
            studio.picture.look = Look::model;
            CHECK(studio.draw() == points);
        }
    }
}

TEST_CASE_METHOD(GlFixture, "balls that are few or near are not all far", "[view]") {
    Studio studio;
    studio.picture.grid.cell_width = 0.02;
    studio.picture.ball_count = far_from;
    CHECK(all_far(studio.picture));
    studio.picture.ball_count = far_from - 1;
    CHECK_FALSE(all_far(studio.picture));
    studio.picture.ball_count = far_from;
    studio.picture.height *= 4;
    CHECK_FALSE(all_far(studio.picture));
    studio.picture.height /= 4;
    studio.picture.camera.position = vec3(0.0f, -1.1f, 0.0f);
    CHECK_FALSE(all_far(studio.picture));
    studio.picture.camera.position = vec3(0.0f);  // inside
    CHECK_FALSE(all_far(studio.picture));
}
