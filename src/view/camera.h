// The eye of the window: plain data and pure functions from one camera to the next. z is up.
// Drags are fractions of the picture's height (x right, y down), so that a drag does the same at every window size.
#pragma once

#include "core/vector.h"

namespace ballpit::view {

using glm::mat4;
using glm::vec2;

struct Camera {
    vec3 position{0.0f};          // m
    float yaw = 0.0f;             // rad, 0 looks along +x, grows to the left (towards +y)
    float pitch = 0.0f;           // rad, positive looks up; within +-maximum_pitch
    float field_of_view = 0.75f;  // rad, vertical
};

/// Just short of straight up and down, where left and right would have no meaning.
inline constexpr float maximum_pitch = 1.55f;

/// Unit vectors of the camera: into the picture, to its right, to its top.
vec3 forward(const Camera& camera);
vec3 right(const Camera& camera);
vec3 up(const Camera& camera);

/// `metres` along the camera's right, forward, and the world's up.
[[nodiscard]] Camera move(Camera camera, const vec3& metres);
/// Turns right and down with the pointer, 2 rad for a drag over the picture's height.
[[nodiscard]] Camera look(Camera camera, const vec2& drag);
/// Moves in the picture's plane; what is as far away as the box's centre stays under the pointer.
[[nodiscard]] Camera pan(Camera camera, const vec2& drag, const vec3& half_extent);
/// One notch of the wheel goes a tenth of the way to the box's centre along the line of sight; negative goes back.
[[nodiscard]] Camera zoom(Camera camera, float notches, const vec3& half_extent);

/// Shows the whole box from a front corner, slightly above, in a picture at least as wide as `aspect` (width / height).
Camera home(const vec3& half_extent, float aspect = 4.0f / 3.0f);

mat4 view_matrix(const Camera& camera);
/// m ahead of the eye of near and far plane, which hold the box and its surroundings, wherever the camera is.
vec2 depth_range(const Camera& camera, const vec3& half_extent);
/// Perspective with these planes.
mat4 projection(const Camera& camera, const vec3& half_extent, float aspect);

}  // namespace ballpit::view
