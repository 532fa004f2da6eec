// Throwing balls and taking hold of walls, without a run: where things start, and what is in their way.
#include "app/window_play.h"
#include "support/catch.h"

using namespace ballpit;

namespace {

const view::Box box{vec3(-4.0f, -3.0f, -2.0f), vec3(4.0f, 3.0f, 2.0f)};
const ui::PlayOptions thrown{0.25, 1000.0, 5.0, 40, false};

// As buffers hold them.
vec4 rounded(const BallSpec& ball) { return {vec3(ball.position), static_cast<float>(ball.radius)}; }

void check_free(const std::vector<BallSpec>& added, std::span<const vec4> others, const view::Box& room) {
    for (std::size_t i = 0; i < added.size(); ++i) {
        const vec4 ball = rounded(added[i]);
        for (int axis = 0; axis < 3; ++axis) {
            CHECK(ball[axis] - ball.w >= room.low[axis] - 1e-5f);
            CHECK(ball[axis] + ball.w <= room.high[axis] + 1e-5f);
        }
        for (std::size_t j = 0; j < i; ++j) {
            CHECK(glm::distance(vec3(ball), vec3(rounded(added[j]))) >= ball.w + rounded(added[j]).w);
        }
        for (const vec4& other : others) {
            CHECK(glm::distance(vec3(ball), vec3(other)) >= (ball.w + other.w) * 0.99999f);
        }
    }
}

}  // namespace

TEST_CASE("a hand takes the wall that is nearest under the pointer, from inside the one behind", "[play]") {
    const view::Ray ahead{vec3(0.5f, -10.0f, 0.25f), vec3(0.0f, 1.0f, 0.0f)};
    const auto front = view::pick_wall(ahead, box);
    REQUIRE(front);
    CHECK(front->axis == 1);
    CHECK_FALSE(front->upper);
    CHECK(front->point == vec3(0.5f, -3.0f, 0.25f));
    const auto back = view::pick_wall({vec3(0.5f, 0.0f, 0.25f), vec3(0.0f, 1.0f, 0.0f)}, box);
    REQUIRE(back);
    CHECK(back->axis == 1);
    CHECK(back->upper);
    const auto top = view::pick_wall({vec3(0.0f, 0.0f, 9.0f), vec3(0.0f, 0.0f, -1.0f)}, box);
    REQUIRE(top);
    CHECK(top->axis == 2);
    CHECK(top->upper);
    CHECK_FALSE(view::pick_wall({vec3(0.0f, -10.0f, 0.0f), vec3(0.0f, -1.0f, 0.0f)}, box));
    CHECK_FALSE(view::pick_wall({vec3(9.0f, -10.0f, 0.0f), vec3(0.0f, 1.0f, 0.0f)}, box));
}

TEST_CASE("a drag follows the pointer along an axis and across a plane", "[play]") {
    const view::Camera camera = view::home(vec3(4.0f), 1.5f);
    const vec3 start(1.0f, -2.0f, 0.5f);
    for (int axis = 0; axis < 3; ++axis) {
        for (const float metres : {-1.5f, 0.0f, 0.75f}) {
            vec3 there = start;
            there[axis] += metres;
            const view::Ray ray{camera.position, glm::normalize(there - camera.position)};
            const auto along = view::drag_along(ray, start, axis);
            REQUIRE(along);
            CHECK(*along == Approx(metres).margin(1e-4));
        }
    }
    CHECK_FALSE(view::drag_along({vec3(0.0f), vec3(1.0f, 0.0f, 0.0f)}, vec3(5.0f, 0.0f, 0.0f), 0));
    const vec3 target = start + 2.0f * view::right(camera) - view::up(camera);
    const auto across =
        view::drag_across({camera.position, glm::normalize(target - camera.position)}, start, -view::forward(camera));
    REQUIRE(across);
    CHECK(glm::distance(*across, target) < 1e-4f);
    CHECK_FALSE(view::drag_across({vec3(0.0f), vec3(1.0f, 0.0f, 0.0f)}, vec3(-5.0f, 0.0f, 0.0f), vec3(1, 0, 0)));
}

TEST_CASE("a shot starts where the line of sight enters the box, behind what is in its way", "[play]") {
    const view::Ray ray{vec3(0.0f, -10.0f, 0.0f), vec3(0.0f, 1.0f, 0.0f)};
    const auto first = app::shot(ray, box, thrown, {});
    REQUIRE(first);
    CHECK(first->position.y == Approx(-2.75));
    CHECK(first->velocity == dvec3(0.0, 5.0, 0.0));
    CHECK(first->mass == Approx(1000.0 * 4.0 / 3.0 * 3.14159265358979 * 0.25 * 0.25 * 0.25));
    std::vector<vec4> balls;
    for (auto next = first; next; next = app::shot(ray, box, thrown, balls)) {
        check_free({*next}, balls, box);
        balls.push_back(rounded(*next));
    }
    CHECK(balls.size() == 11);  // 5.5 m, one every half a metre and a little
    CHECK_FALSE(app::shot({vec3(9.0f, -10.0f, 0.0f), ray.direction}, box, thrown, {}));
    const auto inside = app::shot({vec3(1.0f, 0.0f, 0.0f), ray.direction}, box, thrown, {});
    REQUIRE(inside);
    CHECK(inside->position == dvec3(1.0, 0.0, 0.0));
}

TEST_CASE("a cluster is packed without overlap, inside the walls, beside what is there", "[play]") {
    const view::Ray ray{vec3(0.0f, -10.0f, 0.0f), vec3(0.0f, 1.0f, 0.0f)};
    const auto free = app::cluster(ray, box, thrown, {});
    CHECK(free.size() == thrown.cluster);
    check_free(free, {}, box);
    std::vector<vec4> balls;
    for (const BallSpec& ball : free) {
        balls.push_back(rounded(ball));
        CHECK(ball.velocity == dvec3(0.0));
    }
    const auto second = app::cluster(ray, box, thrown, balls);
    CHECK(second.size() == thrown.cluster);
    check_free(second, balls, box);

    ui::PlayOptions many = thrown;
    many.cluster = ui::largest_cluster;
    const view::Box narrow{vec3(-1.0f, -1.0f, -0.3f), vec3(1.0f, 1.0f, 0.3f)};
    const auto few = app::cluster(ray, narrow, many, {});
    CHECK(few.size() >= 6);
    CHECK(few.size() < 20);
    check_free(few, {}, narrow);
    CHECK(app::cluster({vec3(9.0f, -10.0f, 0.0f), ray.direction}, box, thrown, {}).empty());
}
