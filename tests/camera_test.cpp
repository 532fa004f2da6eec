// Camera, light and palette: pure functions of the view.
#include "view/camera.h"

#include <cmath>
#include <limits>

#include "support/catch.h"
#include "view/light.h"
#include "view/palette.h"

using namespace ballpit;
using namespace ballpit::view;

namespace {

vec3 on_screen(const Camera& camera, const vec3& half_extent, float aspect, const vec3& point) {
    const vec4 clip = projection(camera, half_extent, aspect) * view_matrix(camera) * vec4(point, 1.0f);
    return vec3(clip) / clip.w;
}

bool all_corners_visible(const Camera& camera, const vec3& half_extent, float aspect) {
    for (int corner = 0; corner < 8; ++corner) {
        const vec3 side{(corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1};
        const vec3 place = on_screen(camera, half_extent, aspect, side * half_extent);
        if (glm::any(glm::greaterThan(glm::abs(place), vec3(1.0f)))) {
            return false;
        }
    }
    return true;
}

}  // namespace

TEST_CASE("home shows the whole box, of any shape, from slightly above", "[view]") {
    for (const vec3& half : {vec3(10), vec3(4, 4, 6), vec3(100, 100, 2), vec3(0.01f), vec3(1, 30, 1), vec3(1e4f)}) {
        for (const float aspect : {0.5f, 4.0f / 3.0f, 16.0f / 9.0f, 3.0f}) {
            CAPTURE(half.x, half.y, half.z, aspect);
            const Camera camera = home(half, aspect);
            CHECK(camera.position.z > 0.0f);
            CHECK(camera.pitch < 0.0f);
            CHECK(all_corners_visible(camera, half, aspect));
            const vec3 centre = on_screen(camera, half, aspect, vec3(0.0f));
            CHECK(std::abs(centre.x) + std::abs(centre.y) < 1e-3f);
        }
    }
}

TEST_CASE("z is up on the screen, and right is right", "[view]") {
    const vec3 half{10.0f};
    const Camera camera = home(half);
    CHECK(on_screen(camera, half, 1.5f, {0, 0, 1}).y > 0.0f);
    CHECK(on_screen(camera, half, 1.5f, right(camera)).x > 0.0f);
    CHECK(glm::length(forward(camera)) == Approx(1.0f));
    CHECK(glm::dot(forward(camera), up(camera)) == Approx(0.0f).margin(1e-6));
}

TEST_CASE("moving goes along the camera's own axes, up along the world's", "[view]") {
    Camera camera = look(home(vec3(10.0f)), {0.3f, 0.2f});
    const vec3 start = camera.position;
    CHECK(glm::distance(move(camera, {2, 0, 0}).position, start + 2.0f * right(camera)) < 1e-5f);
    CHECK(glm::distance(move(camera, {0, -3, 0}).position, start - 3.0f * forward(camera)) < 1e-5f);
    CHECK(glm::distance(move(camera, {0, 0, 1}).position, start + vec3(0, 0, 1)) < 1e-5f);
}

TEST_CASE("looking turns with the pointer and never over the top", "[view]") {
    Camera camera;
    CHECK(glm::dot(forward(look(camera, {0.1f, 0.0f})), right(camera)) > 0.0f);
    CHECK(look(camera, {0.0f, 0.1f}).pitch < 0.0f);
    for (int i = 0; i < 100; ++i) {
        camera = look(camera, {0.7f, -0.5f});
    }
    CHECK(camera.pitch == maximum_pitch);
    CHECK(std::abs(camera.yaw) < 3.2f);
    CHECK(std::isfinite(view_matrix(camera)[0][0]));
    CHECK(look(camera, {0.0f, 100.0f}).pitch == -maximum_pitch);
}

TEST_CASE("panning keeps the box's centre under the pointer", "[view]") {
    const vec3 half{5.0f};
    const Camera camera = home(half);
    const vec3 centre = on_screen(pan(camera, {0.25f, 0.1f}, half), half, 1.0f, vec3(0.0f));
    CHECK(centre.x == Approx(0.5f).epsilon(1e-3));
    CHECK(centre.y == Approx(-0.2f).epsilon(1e-3));
}

TEST_CASE("zooming goes forward and back the same way, and never stalls", "[view]") {
    const vec3 half{5.0f};
    const Camera camera = home(half);
    const Camera nearer = zoom(camera, 1.0f, half);
    CHECK(glm::length(nearer.position) == Approx(0.9f * glm::length(camera.position)));
    CHECK(glm::distance(zoom(nearer, -1.0f, half).position, camera.position) < 1e-4f);
    Camera inside;
    CHECK(glm::length(zoom(inside, 1.0f, half).position) > 0.01f);
}

TEST_CASE("the box stays between near and far plane at any distance", "[view]") {
    const vec3 half{4, 4, 6};
    for (const float notches : {-60.0f, -20.0f, 0.0f}) {
        CHECK(all_corners_visible(zoom(home(half), notches, half), half, 4.0f / 3.0f));
    }
}

TEST_CASE("the light orbits above the box at its own speed", "[view]") {
    const vec3 half{4, 4, 6};
    Light light;
    const float start = light.angle;
    CHECK(position(light, half).z > half.z);
    light = advance(light, 0.5f);
    CHECK(light.angle == Approx(start + 0.5f * light.speed));
    for (int i = 0; i < 1000; ++i) {
        light = advance(light, 0.1f);
        REQUIRE(light.angle >= 0.0f);
        REQUIRE(light.angle < 6.2832f);
    }
    light.speed = -light.speed;
    CHECK(advance(light, 1000.0f).angle >= 0.0f);
    light.orbiting = false;
    CHECK(advance(light, 1.0f).angle == light.angle);
}

TEST_CASE("the sequential palette gets lighter all the way, in even steps", "[view]") {
    const auto luminance = [](float t) {
        return glm::dot(linear_from_srgb(sequential(t)), vec3(0.2126f, 0.7152f, 0.0722f));
    };
    for (int i = 0; i < 64; ++i) {
        const float t = static_cast<float>(i) / 64.0f;
        CHECK(std::cbrt(luminance(t + 1.0f / 64.0f)) - std::cbrt(luminance(t)) == Approx(0.0064f).epsilon(0.4));
    }
    CHECK(sequential(-1.0f) == sequential_palette.front());
    CHECK(sequential(2.0f) == sequential_palette.back());
    CHECK(sequential(std::numeric_limits<float>::quiet_NaN()) == sequential_palette.front());
    CHECK(categorical(3) == categorical(11));
}

TEST_CASE("sRGB goes there and back", "[view]") {
    for (const vec3& colour : {vec3(0.0f), vec3(0.02f, 0.5f, 1.0f), vec3(0.2f, 0.04f, 0.9f)}) {
        CHECK(glm::distance(srgb_from_linear(linear_from_srgb(colour)), colour) < 1e-5f);
    }
    CHECK(linear_from_srgb(vec3(0.5f)).x == Approx(0.21404f).epsilon(1e-4));
}
