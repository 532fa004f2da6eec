#include "measure/float_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "measure/pairs.h"

namespace ballpit::measure {

namespace {

constexpr double ulp = std::numeric_limits<float>::epsilon();

// Sums over the contacts of one ball.
struct Contacts {
    double uncertainty = 0.0;   // N, in units of ulp
    double force = 0.0;         // N, sum of magnitudes
    double count = 0.0;
};

struct Bounder {
    const SubstepParams<double>& params;
    Features features;
    std::span<const float> damping_ratios;

    double damping_ratio(std::size_t i) const {
        return features.has(Feature::ball_restitution) ? static_cast<double>(damping_ratios[i]) : params.damping_ratio;
    }

    // docs/accuracy.md, "GPU against mirror": the distance is off by 5 ulp, the normal by 8, the dashpot's
    // coefficient by 7 and its speed by 12; the rest rounds alike on both sides, once per operation.
    void add(Contacts& sum, double reach, double overlap, double speed, double reduced_mass, double zeta) const {
        const double spring = params.stiffness * overlap;
        const double c = features.has(Feature::dashpot) ? 2.0 * zeta * std::sqrt(params.stiffness * reduced_mass) : 0.0;
        const double dashpot = c * speed;
        sum.uncertainty += 8.0 * params.stiffness * reach + 32.0 * dashpot + 16.0 * spring;
        sum.force += spring + dashpot;
        sum.count += 1.0;
    }
};

}  // namespace

CollideBound collide_bound(const SubstepParams<double>& params, Features features, std::span<const vec4> positions,
                           std::span<const vec4> velocities, std::span<const float> damping_ratios) {
    const Bounder bounder{params, features, damping_ratios};
    std::vector<Contacts> contacts(positions.size());
    if (features.has(Feature::contact)) {
        for (const Pair& pair : touching_pairs(positions)) {
            const vec4& a = positions[pair.a];
            const vec4& b = positions[pair.b];
            const double reach = static_cast<double>(a.w) + static_cast<double>(b.w);
            const double overlap = std::max(0.0, reach - glm::distance(dvec3(a), dvec3(b)));
            const double speed = glm::distance(dvec3(velocities[pair.a]), dvec3(velocities[pair.b]));
            const auto mass_a = static_cast<double>(velocities[pair.a].w);
            const auto mass_b = static_cast<double>(velocities[pair.b].w);
            const double zeta = std::max(bounder.damping_ratio(pair.a), bounder.damping_ratio(pair.b));
            for (const std::uint32_t ball : {pair.a, pair.b}) {
                bounder.add(contacts[ball], reach, overlap, speed, mass_a * mass_b / (mass_a + mass_b), zeta);
            }
        }
    }
    CollideBound bound;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const dvec3 x(positions[i]);
        const dvec3 v(velocities[i]);
        const auto radius = static_cast<double>(positions[i].w);
        const auto mass = static_cast<double>(velocities[i].w);
        if (features.has(Feature::walls)) {
            for (int axis = 0; axis < 3; ++axis) {
                const double overlap = radius - (params.half_extent[axis] - std::abs(x[axis]));
                if (overlap > 0.0) {
                    bounder.add(contacts[i], 0.0, overlap, std::abs(v[axis]), mass, bounder.damping_ratio(i));
                }
            }
        }
        // Sums may round differently once their terms differ: one ulp an addition.
        const Contacts& sum = contacts[i];
        const double gravity = features.has(Feature::gravity) ? glm::length(params.gravity) : 0.0;
        const double acceleration = sum.force / mass + gravity;
        const double force_error = ulp * (sum.uncertainty + 2.0 * (sum.count + 2.0) * sum.force);
        const bool touched = sum.count > 0.0;   // free flight has no division that is not of 0
        const double acceleration_error = touched ? force_error / mass + 6.0 * ulp * acceleration : 0.0;
        const double gain = std::abs(params.gain) + std::abs(params.second_gain);
        const double speed = glm::length(v) + gain * acceleration;
        const double velocity_error = gain * acceleration_error + (touched ? 6.0 * ulp * speed : 0.0);
        const double drift = std::abs(params.drift);
        const double position_error = drift * (velocity_error + drift * acceleration_error) +
                                      (touched ? 3.0 * ulp * (glm::length(x) + drift * speed) : 0.0);
        bound.velocity.push_back(velocity_error);
        bound.position.push_back(position_error);
    }
    return bound;
}

}  // namespace ballpit::measure
