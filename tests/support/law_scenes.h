// Scenes by what they model, for tests of what laws cost and change.
#pragma once

#include <string_view>

#include "core/scene.h"

namespace ballpit::test {

/// Equal balls close together in a box of 1 m to each side, so that most of them touch soon, with these laws.
inline Scene scene_with(std::string_view laws, std::uint32_t balls) {
    Scene scene;
    scene.name = std::string(laws);
    scene.half_extent = dvec3(1.0);
    scene.settings.laws = parse_laws(laws);
    scene.settings.balls = balls;
    scene.settings.stiffness = 2000.0;
    scene.settings.restitution = 0.7;
    scene.fill = Fill{balls, {0.08, 0.08}, 1000.0, 1.0, {dvec3(-0.95), dvec3(0.95)}, 11};
    return scene;
}

inline Scene free_fall_scene(std::uint32_t balls) { return scene_with("gravity", balls); }
inline Scene elastic_gas_scene(std::uint32_t balls) { return scene_with("contact,walls", balls); }
inline Scene mono_pile_scene(std::uint32_t balls) { return scene_with("gravity,contact,restitution,walls", balls); }

/// The same with radii and masses that differ.
inline Scene mixed_pile_scene(std::uint32_t balls) {
    Scene scene = mono_pile_scene(balls);
    scene.fill->radius = {0.05, 0.1};
    return scene;
}

}  // namespace ballpit::test
