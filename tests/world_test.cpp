// The starting state: a pure function of scene, count and seed.
#include "core/world.h"

#include <cmath>
#include <numbers>

#include "core/scene_file.h"
#include "support/catch.h"
#include "support/input_error.h"
#include "support/scenes.h"

using namespace ballpit;

namespace {

Scene filled_scene(std::uint32_t count) {
    Scene scene;
    scene.name = "filled";
    scene.half_extent = {2, 3, 4};
    scene.settings.laws.contact = true;
    scene.fill = Fill{count, {0.05, 0.1}, 1000.0, 2.0, {dvec3(-2, -3, 0), dvec3(2, 3, 4)}, 9};
    scene.settings.balls = count;
    return scene;
}

double widest_overlap(const BallState& balls) {
    double widest = -1.0;
    for (std::size_t a = 0; a < balls.count(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            const dvec3 offset = dvec3(balls.positions[a]) - dvec3(balls.positions[b]);
            const double reach = static_cast<double>(balls.positions[a].w) + static_cast<double>(balls.positions[b].w);
            widest = std::max(widest, reach - glm::length(offset));
        }
    }
    return widest;
}

}  // namespace

TEST_CASE("the fill lies inside its region, touches nobody, and has the size, mass and speed asked for", "[core]") {
    const Scene scene = filled_scene(1500);
    const World world = make_world(scene, 1500, 9);
    REQUIRE(world.balls.count() == 1500);
    REQUIRE(world.balls.velocities.size() == 1500);
    CHECK(world.overlapping == 0);
    CHECK(widest_overlap(world.balls) <= 0.0);
    CHECK(world.balls.restitutions.empty());
    CHECK(world.balls.velocity_lag == 0.0);
    const Fill& fill = *scene.fill;
    for (std::size_t i = 0; i < world.balls.count(); ++i) {
        const dvec3 centre(world.balls.positions[i]);
        const auto radius = static_cast<double>(world.balls.positions[i].w);
        CHECK(radius >= 0.05 - 1e-8);
        CHECK(radius <= 0.1 + 1e-8);
        for (int axis = 0; axis < 3; ++axis) {
            CHECK(centre[axis] - radius >= fill.region[0][axis] - 1e-6);
            CHECK(centre[axis] + radius <= fill.region[1][axis] + 1e-6);
        }
        const double mass = 1000.0 * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
        CHECK(static_cast<double>(world.balls.velocities[i].w) == Approx(mass).epsilon(1e-6));
        CHECK(glm::length(dvec3(world.balls.velocities[i])) == Approx(2.0).epsilon(1e-6));
    }
}

TEST_CASE("directions of the fill have no preference", "[core]") {
    const World world = make_world(filled_scene(1500), 1500, 3);
    dvec3 sum(0.0);
    for (const vec4& velocity : world.balls.velocities) {
        sum += dvec3(velocity) / 2.0;
    }
    for (int axis = 0; axis < 3; ++axis) {
        CHECK(std::abs(sum[axis]) < 4.0 * std::sqrt(1500.0 / 3.0));  // four standard deviations
    }
}

TEST_CASE("ball i is the same ball for every count", "[core]") {
    const Scene scene = filled_scene(100);
    const World all = make_world(scene, 1000, 9);
    for (const std::uint32_t count : {0u, 1u, 63u, 64u, 65u, 999u}) {
        const World some = make_world(scene, count, 9);
        REQUIRE(some.balls.count() == count);
        for (std::uint32_t i = 0; i < count; ++i) {
            REQUIRE(some.balls.positions[i] == all.balls.positions[i]);
            REQUIRE(some.balls.velocities[i] == all.balls.velocities[i]);
        }
    }
}

TEST_CASE("the same seed gives the same world, another seed another one", "[core]") {
    const Scene scene = filled_scene(200);
    CHECK(hash_state(make_world(scene, 200, 1).balls) == hash_state(make_world(scene, 200, 1).balls));
    CHECK(hash_state(make_world(scene, 200, 1).balls) != hash_state(make_world(scene, 200, 2).balls));
}

TEST_CASE("listed balls come first, and the fill keeps clear of them", "[core]") {
    Scene scene = filled_scene(300);
    scene.balls = {{{0, 0, 2}, {1, 2, 3}, 0.8, 5.0, std::nullopt}, {{1, -2, 3}, {}, 0.5, 6.0, 0.25}};
    scene.settings.laws.restitution = true;
    scene.settings.restitution = 0.75;
    const World world = make_world(scene, 302, 4);
    CHECK(world.balls.positions[0] == vec4(0, 0, 2, 0.8f));
    CHECK(world.balls.velocities[0] == vec4(1, 2, 3, 5));
    CHECK(world.balls.positions[1] == vec4(1, -2, 3, 0.5f));
    CHECK(world.overlapping == 0);
    CHECK(widest_overlap(world.balls) <= 0.0);
    // One ball has a restitution of its own, so each needs one: the others get the scene's.
    REQUIRE(world.balls.restitutions.size() == 302);
    CHECK(world.balls.restitutions[0] == 0.75f);
    CHECK(world.balls.restitutions[1] == 0.25f);
    CHECK(world.balls.restitutions[301] == 0.75f);
    CHECK(make_world(scene, 1, 4).balls.count() == 1);
}

TEST_CASE("a region too small for its balls says how many overlap", "[core]") {
    Scene scene = filled_scene(500);
    scene.fill->region = {dvec3(-0.2), dvec3(0.2)};
    const World world = make_world(scene, 500, 9);
    CHECK(world.balls.count() == 500);
    CHECK(world.overlapping > 300);
    for (const vec4& position : world.balls.positions) {
        CHECK(std::isfinite(position.x + position.y + position.z));
    }
}

TEST_CASE("a region narrower than a ball puts it in the middle", "[core]") {
    Scene scene = filled_scene(1);
    scene.fill->region = {dvec3(0.5, -3, 0), dvec3(0.5, 3, 4)};
    CHECK(make_world(scene, 1, 9).balls.positions[0].x == 0.5f);
}

TEST_CASE("beyond the reference count the box widens, and the pile stays as deep", "[core]") {
    Scene scene = filled_scene(100);
    scene.reference_count = 100;
    CHECK(widening(scene, 0) == 1.0);
    CHECK(widening(scene, 100) == 1.0);
    CHECK(widening(scene, 400) == Approx(2.0).epsilon(1e-15));
    const World world = make_world(scene, 400, 9);
    CHECK(world.box.upper.x == Approx(4.0));
    CHECK(world.box.upper.y == Approx(6.0));
    CHECK(world.box.upper.z == 4.0);
    scene.reference_count = 0;
    CHECK(widening(scene, 4000000) == 1.0);
}

TEST_CASE("more balls than a scene without fill can give are refused", "[core]") {
    const Scene scene = test::shipped_scene("two_balls");
    CHECK(make_world(scene, 2, 0).balls.count() == 2);
    CHECK(test::complaint_of([&] { make_world(scene, 3, 0); }) ==
          "setting 'balls' cannot be 3: scene 'Two balls' lists 2 and has no fill");
}
