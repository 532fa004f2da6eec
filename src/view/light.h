// The one point light, which orbits above the balls. Plain data and pure functions; sizes are relative to the box,
// so that a light is as good in every scene.
#pragma once

#include "core/vector.h"

namespace ballpit::view {

struct Light {
    bool orbiting = true;
    float angle = 5.2f;              // rad about z, 0 towards +x
    float radius_factor = 0.6f;      // of the box's half width and depth
    float height = 1.25f;            // above the box's centre, of the box's largest half extent
    float speed = 0.25f;             // rad/s
    vec3 colour{1.0f, 0.97f, 0.9f};  // as on screen (sRGB), 0 to 1
    float intensity = 1.1f;
    float ambient = 0.4f;  // light from everywhere, so that no side is black
};

/// The light `dt` seconds later; angle stays within one turn.
[[nodiscard]] Light advance(Light light, float dt);

/// m
vec3 position(const Light& light, const vec3& half_extent);

}  // namespace ballpit::view
