#include "view/light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ballpit::view {

Light advance(Light light, float dt) {
    if (light.orbiting) {
        constexpr float turn = 2.0f * std::numbers::pi_v<float>;
        light.angle = std::fmod(light.angle + light.speed * dt, turn);
        light.angle += light.angle < 0.0f ? turn : 0.0f;
    }
    return light;
}

vec3 position(const Light& light, const vec3& half_extent) {
    const float largest = std::max({half_extent.x, half_extent.y, half_extent.z});
    return {light.radius_factor * half_extent.x * std::cos(light.angle),
            light.radius_factor * half_extent.y * std::sin(light.angle), light.height * largest};
}

}  // namespace ballpit::view
