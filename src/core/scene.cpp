#include "core/scene.h"

#include <algorithm>
#include <cmath>

namespace ballpit {

double widening(const Scene& scene, std::uint32_t balls) {
    if (scene.reference_count == 0 || balls <= scene.reference_count) {
        return 1.0;
    }
    return std::sqrt(static_cast<double>(balls) / scene.reference_count);
}

Features scene_features(const Scene& scene, const Settings& settings) {
    const bool own = std::ranges::any_of(scene.balls, [](const BallSpec& b) { return b.restitution.has_value(); });
    Features features;
    features.add(Feature::gravity, scene.laws.gravity);
    features.add(Feature::drag, scene.laws.drag);
    features.add(Feature::contact, scene.laws.contact);
    features.add(Feature::dashpot, scene.laws.restitution || own);
    features.add(Feature::limit_force, settings.limit_force && (scene.laws.restitution || own));
    features.add(Feature::walls, scene.laws.walls);
    features.add(Feature::ball_restitution, own);
    features.add(Feature::velocity_verlet, settings.integrator == Integrator::velocity_verlet);
    features.add(Feature::forward_euler, settings.integrator == Integrator::forward_euler);
    features.add(Feature::historical, settings.integrator == Integrator::historical);
    features.add(Feature::brute_force, scene.laws.contact && settings.neighbours == NeighbourSearch::brute_force);
    return features;
}

}  // namespace ballpit
