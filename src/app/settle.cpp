#include "app/settle.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/error.h"
#include "core/stopwatch.h"

namespace ballpit::app {

namespace {

constexpr double filled_share = 0.15;  // of the volume, by balls: random places are still found at once
constexpr int steps_between_looks = 10;

// Of all balls, over the sum of their weights times their radii; velocities half a substep old are as good.
double kinetic_share(Simulation& simulation) {
    const auto positions = read_slot<vec4>(simulation.backend(), Slot::positions);
    const auto velocities = read_slot<vec4>(simulation.backend(), Slot::velocities);
    const double gravity = glm::length(simulation.settings().gravity);
    double kinetic = 0.0;
    double scale = 0.0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const dvec3 v(velocities[i]);
        const auto mass = static_cast<double>(velocities[i].w);
        kinetic += 0.5 * mass * glm::dot(v, v);
        scale += mass * gravity * std::abs(static_cast<double>(positions[i].w));
    }
    return scale > 0.0 ? kinetic / scale : 0.0;
}

}  // namespace

Scene lowered(const Scene& scene, std::uint32_t balls) {
    Scene low = scene;
    if (!low.fill) {
        return low;
    }
    auto& [lower, upper] = low.fill->region;
    const double wide = widening(scene, balls);
    const double floor = (upper.x - lower.x) * (upper.y - lower.y) * wide * wide;
    const double volume = balls * sphere_mass(low.fill->radius[1], 1.0);
    const double height = volume / (filled_share * floor) + 2.0 * low.fill->radius[1];
    upper.z = std::min(upper.z, lower.z + height);
    return low;
}

Settling settle(Simulation& simulation, double limit_s) {
    if (!simulation.settings().laws.gravity || glm::length(simulation.settings().gravity) == 0.0) {
        throw InputError("--state settled: scene '" + simulation.scene().name + "' has no gravity, nothing settles");
    }
    const auto start = std::chrono::steady_clock::now();
    Settling settling;
    do {
        for (int i = 0; i < steps_between_looks && settling.seconds < limit_s; ++i, ++settling.steps) {
            simulation.step();
            simulation.backend().finish();
            settling.seconds = 1e-3 * milliseconds_since(start);
        }
        settling.kinetic = kinetic_share(simulation);
        settling.at_rest = settling.kinetic < at_rest_below;
        settling.seconds = 1e-3 * milliseconds_since(start);
    } while (!settling.at_rest && settling.seconds < limit_s);
    return settling;
}

}  // namespace ballpit::app
