// What lies under the pointer, and how the camera flies there. Pure functions; points are fractions of the picture
// from its upper left corner, `aspect` its width / height.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/layout.h"
#include "view/camera.h"
#include "view/overlay.h"

namespace ballpit::view {

struct Ray {
    vec3 origin{0.0f};
    vec3 direction{0.0f};  // unit
};
Ray ray_through(const Camera& camera, float aspect, const vec2& point);

/// The nearest ball that is drawn under the point: not one around the eye, before the near plane, or not finite.
/// `positions`: centre, radius. With a slice that cuts away, balls before it are looked through.
std::optional<std::uint32_t> pick_ball(const Camera& camera, const vec3& half_extent, float aspect, const vec2& point,
                                       std::span<const vec4> positions);
std::optional<std::uint32_t> pick_ball(const Camera& camera, const vec3& half_extent, float aspect, const vec2& point,
                                       std::span<const vec4> positions, const Grid& grid, const GridSlice& slice);

/// Id of the nearest occupied cell under the point; with a slice, of the cell of its layer, occupied or not.
std::optional<std::uint32_t> pick_cell(const Camera& camera, float aspect, const vec2& point, const Grid& grid,
                                       std::span<const CellRange> ranges);
std::optional<std::uint32_t> pick_cell(const Camera& camera, float aspect, const vec2& point, const Grid& grid,
                                       const GridSlice& slice);

/// Looks the same way, with a ball (or anything of this radius, m) in the middle, a sixth of the picture high.
[[nodiscard]] Camera fly_to(const Camera& camera, const vec3& target, float radius);
/// On the way from one camera to another: starts and ends slowly, turns the short way round. t 0 is a, 1 is b.
[[nodiscard]] Camera blend(const Camera& a, const Camera& b, float t);

}  // namespace ballpit::view
