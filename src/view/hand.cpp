#include "view/hand.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ballpit::view {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

// Distances at which the ray crosses the two planes of an axis, the nearer one first.
struct Crossing {
    float near = -infinity;
    float far = infinity;
};

std::optional<Crossing> crossing(const Ray& ray, const Box& box, int axis) {
    const float start = ray.origin[axis];
    if (ray.direction[axis] == 0.0f) {
        return start < box.low[axis] || start > box.high[axis] ? std::nullopt : std::optional(Crossing{});
    }
    const float low = (box.low[axis] - start) / ray.direction[axis];
    const float high = (box.high[axis] - start) / ray.direction[axis];
    return Crossing{std::min(low, high), std::max(low, high)};
}

struct Walls {
    float enter = -infinity;
    float leave = infinity;
    int enter_axis = 0;
    int leave_axis = 0;
};

std::optional<Walls> walls_on(const Ray& ray, const Box& box) {
    Walls walls;
    for (int axis = 0; axis < 3; ++axis) {
        const auto planes = crossing(ray, box, axis);
        if (!planes) {
            return std::nullopt;
        }
        if (planes->near > walls.enter) {
            walls.enter = planes->near;
            walls.enter_axis = axis;
        }
        if (planes->far < walls.leave) {
            walls.leave = planes->far;
            walls.leave_axis = axis;
        }
    }
    return walls.enter < walls.leave && walls.leave > 0.0f ? std::optional(walls) : std::nullopt;
}

}  // namespace

std::optional<RaySpan> span_in(const Ray& ray, const Box& box) {
    const auto walls = walls_on(ray, box);
    return walls ? std::optional(RaySpan{std::max(walls->enter, 0.0f), walls->leave}) : std::nullopt;
}

std::optional<WallHit> pick_wall(const Ray& ray, const Box& box) {
    const auto walls = walls_on(ray, box);
    if (!walls) {
        return std::nullopt;
    }
    const bool inside = walls->enter <= 0.0f;
    const int axis = inside ? walls->leave_axis : walls->enter_axis;
    const float distance = inside ? walls->leave : walls->enter;
    const bool upper = (ray.direction[axis] > 0.0f) == inside;
    return WallHit{axis, upper, ray.origin + distance * ray.direction};
}

std::optional<float> drag_along(const Ray& ray, const vec3& point, int axis) {
    constexpr float least = 0.003f;  // of the sine squared: about three degrees
    const float along = ray.direction[axis];
    const float sine_squared = 1.0f - along * along;
    if (!(sine_squared > least)) {
        return std::nullopt;
    }
    const vec3 from_eye = point - ray.origin;
    return (along * glm::dot(ray.direction, from_eye) - from_eye[axis]) / sine_squared;
}

std::optional<vec3> drag_across(const Ray& ray, const vec3& point, const vec3& normal) {
    const float towards = glm::dot(ray.direction, normal);
    const float distance = glm::dot(point - ray.origin, normal) / towards;
    if (!(distance > 0.0f) || !std::isfinite(distance)) {
        return std::nullopt;
    }
    return ray.origin + distance * ray.direction;
}

}  // namespace ballpit::view
