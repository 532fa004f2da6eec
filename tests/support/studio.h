// A renderer, a bare picture of a box of 2 m, and what becomes of it, pixel by pixel.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "core/layout.h"
#include "gl/framebuffer.h"
#include "support/catch.h"
#include "view/renderer.h"

namespace ballpit::test {

using namespace ballpit::view;
using Pixels = std::vector<unsigned char>;

inline constexpr int width = 320;
inline constexpr int height = 240;
inline constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

inline std::filesystem::path source(const char* name) { return std::filesystem::path(BALLPIT_SOURCE_DIR) / name; }

template <class T>
gl::Buffer buffer_of(const std::vector<T>& elements) {
    gl::Buffer buffer("test", elements.size() * sizeof(T));
    buffer.write(std::as_bytes(std::span(elements)));
    return buffer;
}

struct Studio {
    Renderer renderer;
    gl::Framebuffer framebuffer{width, height};
    gl::Buffer positions;
    gl::Buffer velocities;
    Picture picture;

    explicit Studio(bool computes = true)
        : renderer(source("glsl"), load_model(source("assets/models/ball.obj")), computes) {
        picture.half_extent = vec3(1.0f);
        picture.box = {vec3(-1.0f), vec3(1.0f)};
        picture.grid = make_grid(dvec3(1.0), 0.25, 1.0, 1);
        picture.camera = home(picture.half_extent);
        picture.show_box = picture.show_ground = picture.show_light = false;
        picture.width = width;
        picture.height = height;
    }

    void set_balls(const std::vector<vec4>& balls, const std::vector<vec4>& speeds = {}) {
        positions = buffer_of(balls);
        velocities = buffer_of(speeds);
        picture.positions = &positions;
        picture.velocities = speeds.empty() ? nullptr : &velocities;
        picture.ball_count = static_cast<std::uint32_t>(balls.size());
    }

    Pixels draw() {
        framebuffer.bind();
        renderer.draw(picture);
        return framebuffer.pixels();
    }
};

inline std::size_t index_of(int x, int y) {
    return 3 * (static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x));
}

inline std::vector<bool> changed(const Pixels& a, const Pixels& b) {
    std::vector<bool> mask;
    for (std::size_t i = 0; i < a.size(); i += 3) {
        mask.push_back(!std::equal(a.begin() + static_cast<std::ptrdiff_t>(i),
                                   a.begin() + static_cast<std::ptrdiff_t>(i) + 3,
                                   b.begin() + static_cast<std::ptrdiff_t>(i)));
    }
    return mask;
}

inline std::ptrdiff_t count(const std::vector<bool>& mask) { return std::count(mask.begin(), mask.end(), true); }

// Which pixels' rays meet the ball.
inline std::vector<bool> cast_rays(const Camera& camera, const vec4& ball) {
    std::vector<bool> mask;
    const float high = std::tan(0.5f * camera.field_of_view);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const float u = (2.0f * (static_cast<float>(x) + 0.5f) / width - 1.0f) * high * width / height;
            const float v = (1.0f - 2.0f * (static_cast<float>(y) + 0.5f) / height) * high;
            const vec3 ray = glm::normalize(forward(camera) + u * right(camera) + v * up(camera));
            const vec3 to_ball = vec3(ball) - camera.position;
            const float along = glm::dot(to_ball, ray);
            mask.push_back(along > 0.0f && glm::length(to_ball - along * ray) < ball.w);
        }
    }
    return mask;
}

inline std::ptrdiff_t differences(const std::vector<bool>& a, const std::vector<bool>& b) {
    std::ptrdiff_t n = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        n += a[i] != b[i] ? 1 : 0;
    }
    return n;
}

inline vec3 pixel_at(const Pixels& pixels, const Picture& picture, const vec3& place) {
    const mat4 matrix = projection(picture.camera, picture.half_extent, static_cast<float>(width) / height) *
                        view_matrix(picture.camera);
    const vec4 clip = matrix * vec4(place, 1.0f);
    const int x = static_cast<int>((0.5f + 0.5f * clip.x / clip.w) * width);
    const int y = static_cast<int>((0.5f - 0.5f * clip.y / clip.w) * height);
    const std::size_t i = index_of(x, y);
    return {pixels[i], pixels[i + 1], pixels[i + 2]};
}

inline constexpr float half_turn = 3.14159265f;
inline constexpr vec4 red{1.0f, 0.0f, 0.0f, 1.0f};
inline constexpr std::array looks = {Look::model, Look::impostor};

// A studio with an overlay, seen from the front: x to the right, z up; no shadows; 4 x 4 x 4 cells.
struct Inside : Studio {
    Overlay overlay;
    gl::Buffer ranges;

    Inside() {
        picture.overlay = &overlay;
        picture.camera = Camera{};
        picture.camera.position = {0, -5, 0};
        picture.camera.yaw = 0.5f * half_turn;
        picture.show_shadows = false;
        picture.grid = make_grid(dvec3(1.0), 0.25, 1.0, 1);
        REQUIRE(picture.grid.cells == uvec3(4));
    }

    // Balls a cell; what is not named is empty.
    void set_counts(std::initializer_list<std::pair<uvec3, std::uint32_t>> counts) {
        std::vector<CellRange> table(picture.grid.cell_count(), CellRange{0, 0});
        for (const auto& [cell, n] : counts) {
            table[(cell.z * 4 + cell.y) * 4 + cell.x] = {7, 7 + n};
        }
        ranges = buffer_of(table);
        picture.cell_ranges = &ranges;
    }

    vec3 at(const Pixels& pixels, const vec3& place) const { return pixel_at(pixels, picture, place); }
    float pixels_a_metre() const { return 0.5f * height / std::tan(0.5f * picture.camera.field_of_view) / 5.0f; }
};

inline bool near_to(const vec3& a, const vec3& b, float tolerance) {
    return glm::all(glm::lessThanEqual(glm::abs(a - b), vec3(tolerance)));
}

}  // namespace ballpit::test
