#include "view/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace ballpit::view {

namespace {

constexpr float turn_per_height = 2.0f;
constexpr float full_turn = 2.0f * std::numbers::pi_v<float>;
constexpr vec3 world_up{0.0f, 0.0f, 1.0f};

float distance_to_centre(const Camera& camera, const vec3& half_extent) {
    // Near the centre, steps must not shrink to nothing.
    return std::max(glm::length(camera.position), 0.1f * glm::length(half_extent));
}

}  // namespace

vec3 forward(const Camera& camera) {
    const float level = std::cos(camera.pitch);
    return {level * std::cos(camera.yaw), level * std::sin(camera.yaw), std::sin(camera.pitch)};
}

vec3 right(const Camera& camera) { return {std::sin(camera.yaw), -std::cos(camera.yaw), 0.0f}; }

vec3 up(const Camera& camera) { return glm::cross(right(camera), forward(camera)); }

Camera move(Camera camera, const vec3& metres) {
    camera.position += metres.x * right(camera) + metres.y * forward(camera) + metres.z * world_up;
    return camera;
}

Camera look(Camera camera, const vec2& drag) {
    camera.yaw = std::remainder(camera.yaw - turn_per_height * drag.x, full_turn);
    camera.pitch = std::clamp(camera.pitch - turn_per_height * drag.y, -maximum_pitch, maximum_pitch);
    return camera;
}

Camera pan(Camera camera, const vec2& drag, const vec3& half_extent) {
    const float height = 2.0f * std::tan(0.5f * camera.field_of_view) * distance_to_centre(camera, half_extent);
    camera.position += height * (drag.y * up(camera) - drag.x * right(camera));
    return camera;
}

Camera zoom(Camera camera, float notches, const vec3& half_extent) {
    const float share = 1.0f - std::pow(0.9f, notches);
    camera.position += share * distance_to_centre(camera, half_extent) * forward(camera);
    return camera;
}

Camera home(const vec3& half_extent, float aspect) {
    Camera camera;
    const vec3 to_centre = glm::normalize(vec3(-0.55f, 1.0f, -0.42f));
    camera.yaw = std::atan2(to_centre.y, to_centre.x);
    camera.pitch = std::asin(to_centre.z);
    const float height = std::tan(0.5f * camera.field_of_view);  // of the picture, 1 m away, from its middle
    float distance = 0.0f;
    for (int corner = 0; corner < 8; ++corner) {
        const vec3 side{(corner & 1) != 0 ? 1.0f : -1.0f, (corner & 2) != 0 ? 1.0f : -1.0f,
                        (corner & 4) != 0 ? 1.0f : -1.0f};
        const vec3 point = side * half_extent;
        const float wide = std::abs(glm::dot(point, right(camera))) / (height * aspect);
        const float high = std::abs(glm::dot(point, up(camera))) / height;
        distance = std::max(distance, std::max(wide, high) - glm::dot(point, forward(camera)));
    }
    constexpr float margin = 1.1f;  // room for the light above
    camera.position = -margin * distance * forward(camera);
    return camera;
}

mat4 view_matrix(const Camera& camera) {
    // Turned at the origin: far away, position + forward would round the direction.
    return glm::translate(glm::lookAt(vec3(0.0f), forward(camera), world_up), -camera.position);
}

vec2 depth_range(const Camera& camera, const vec3& half_extent) {
    // Three times the box holds the ground around it and the light above it.
    const float radius = glm::length(half_extent);
    const float distance = glm::length(camera.position);
    return {std::max(0.002f * radius, distance - 3.0f * radius), distance + 3.0f * radius};
}

mat4 projection(const Camera& camera, const vec3& half_extent, float aspect) {
    const vec2 planes = depth_range(camera, half_extent);
    return glm::perspective(camera.field_of_view, aspect, planes.x, planes.y);
}

}  // namespace ballpit::view
