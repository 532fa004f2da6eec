// What a hand in the picture gets hold of, and where it drags it: rays against boxes, planes and axes. Pure functions.
#pragma once

#include <optional>

#include "view/picking.h"

namespace ballpit::view {

/// m along the ray, from where it enters a box (0 from inside) to where it leaves.
struct RaySpan {
    float enter = 0.0f;
    float leave = 0.0f;
};
/// Nothing where the ray misses the box, or the box lies behind the eye or has no inside.
std::optional<RaySpan> span_in(const Ray& ray, const Box& box);

/// A wall of the box: across `axis` 0, 1, 2, the upper or the lower one, and where the ray meets it.
struct WallHit {
    int axis = 0;
    bool upper = false;
    vec3 point{0.0f};
};
/// The wall nearest to the eye under the ray; from inside the box the one that the ray leaves through.
std::optional<WallHit> pick_wall(const Ray& ray, const Box& box);

/// m along `axis` from `point` to where the line through it comes nearest to the ray. Nothing where the eye looks along
/// the axis: then a drag has no measure.
std::optional<float> drag_along(const Ray& ray, const vec3& point, int axis);

/// Where the ray meets the plane through `point` that stands square to `normal`, before the eye.
std::optional<vec3> drag_across(const Ray& ray, const vec3& point, const vec3& normal);

}  // namespace ballpit::view
