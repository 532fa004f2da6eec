// The look for a CPU that draws: what it shows, in which order, and what it leaves out.
#include <algorithm>

#include "core/random.h"
#include "support/gl_fixture.h"
#include "support/studio.h"
#include "view/depth_order.h"
#include "view/hidden_balls.h"

using namespace ballpit;
using namespace ballpit::test;

namespace {

// Two balls that touch, one behind the other, and one beside them.
const std::vector<vec4> three = {vec4(0, 0.4f, 0, 0.3f), vec4(0, -0.2f, 0, 0.3f), vec4(0.7f, 0, 0, 0.2f)};

}  // namespace

TEST_CASE_METHOD(test::GlFixture, "the order of drawing changes no pixel of the simple look", "[view]") {
    Studio studio;
    studio.picture.look = Look::simple;
    studio.set_balls(three);
    const Pixels any = studio.draw();
    for (const std::vector<std::uint32_t>& order :
         {std::vector<std::uint32_t>{2, 1, 0}, nearest_first(three, studio.picture.camera)}) {
        const gl::Buffer buffer = buffer_of(order);
        studio.picture.order = &buffer;
        studio.picture.order_count = static_cast<std::uint32_t>(order.size());
        CHECK(count(changed(any, studio.draw())) == 0);
    }
}

TEST_CASE_METHOD(test::GlFixture, "balls that are hidden are not drawn, and no pixel tells", "[view]") {
    Studio studio;
    studio.picture.look = Look::simple;
    // A pile of large and small balls that do not overlap, some of them beside the picture.
    std::vector<vec4> balls;
    for (int i = 0; i < 9 * 9 * 9; ++i) {
        const vec3 cell(i % 9, i / 9 % 9, i / 81);
        balls.emplace_back(0.25f * (cell - 4.0f),
                           0.06f + 0.06f * static_cast<float>(random_unit(7, 0, static_cast<std::uint64_t>(i))));
    }
    balls[100].x = not_a_number;
    balls[101].w = -balls[101].w;
    studio.set_balls(balls);
    const Camera home = studio.picture.camera;
    std::size_t fewest = balls.size();
    for (const float nearer : {0.0f, 0.3f, 0.55f}) {
        for (const float turn : {0.0f, 0.4f, 2.0f}) {
            studio.picture.camera = home;
            studio.picture.camera.position *= 1.0f - nearer;
            studio.picture.camera.yaw += turn;
            studio.picture.order = nullptr;
            const Pixels all = studio.draw();
            const auto seen = without_hidden(nearest_first(balls, studio.picture.camera), balls, studio.picture);
            const gl::Buffer buffer = buffer_of(seen.empty() ? std::vector<std::uint32_t>{0} : seen);
            studio.picture.order = &buffer;
            studio.picture.order_count = static_cast<std::uint32_t>(seen.size());
            CAPTURE(nearer, turn, seen.size());
            CHECK(count(changed(all, studio.draw())) == 0);
            fewest = turn == 0.0f ? std::min(fewest, seen.size()) : fewest;
        }
    }
    CHECK(fewest < balls.size() / 2);
}

TEST_CASE_METHOD(test::GlFixture, "balls of the simple look that reach into the picture are drawn", "[view]") {
    Studio studio;
    studio.picture.look = Look::simple;
    const Pixels empty = studio.draw();
    const Camera camera = studio.picture.camera;
    for (float beside = 0.0f; beside < 4.0f; beside += 0.25f) {
        for (const vec3& way : {right(camera), -right(camera), up(camera), -up(camera)}) {
            const vec4 ball(beside * way, 0.25f);
            studio.set_balls({ball});
            CAPTURE(beside, way.x, way.y, way.z);
            CHECK(differences(changed(empty, studio.draw()), cast_rays(camera, ball)) <= 4);
        }
    }
}

TEST_CASE_METHOD(test::GlFixture, "from near by, simple balls are drawn all the same", "[view]") {
    Studio studio;
    studio.picture.look = Look::simple;
    const Pixels empty = studio.draw();
    Camera camera = studio.picture.camera;
    camera.position = -0.9f * forward(camera);
    studio.picture.camera = camera;
    const vec4 ball(0, 0, 0, 0.5f);
    studio.set_balls({ball});
    CHECK(differences(changed(empty, studio.draw()), cast_rays(camera, ball)) <= 8);
}

TEST_CASE_METHOD(test::GlFixture, "the simple look throws no shadows", "[view]") {
    Studio studio;
    studio.picture.look = Look::simple;
    studio.picture.show_ground = true;
    studio.set_balls({vec4(0, 0, 0.5f, 0.2f)});
    studio.picture.show_shadows = true;
    const Pixels with = studio.draw();
    studio.picture.show_shadows = false;
    CHECK(count(changed(with, studio.draw())) == 0);
}

TEST_CASE("balls come from near to far, each once", "[view]") {
    Camera camera;
    camera.position = {0, -5, 0};
    camera.yaw = 0.5f * half_turn;
    std::vector<vec4> balls;
    balls.reserve(500);
    for (int i = 0; i < 500; ++i) {
        balls.emplace_back(0.01f * static_cast<float>(i % 7), static_cast<float>((i * 37) % 500), 0.0f, 0.1f);
    }
    balls[10].y = not_a_number;
    const std::vector<std::uint32_t> order = nearest_first(balls, camera);
    std::vector<std::uint32_t> sorted = order;
    std::ranges::sort(sorted);
    for (std::uint32_t i = 0; i < sorted.size(); ++i) {
        REQUIRE(sorted[i] == i);
    }
    for (std::size_t i = 1; i < order.size(); ++i) {
        const float before = balls[order[i - 1]].y;
        const float after = balls[order[i]].y;
        CHECK((before <= after || std::isnan(before) || std::isnan(after)));
    }
    CHECK(nearest_first({}, camera).empty());
    CHECK(nearest_first(std::vector<vec4>(3, vec4(1.0f)), camera).size() == 3);
}
