#include "measure/momentum.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/quarantine.h"
#include "measure/float_bound.h"

namespace ballpit::measure {

namespace {

// Both kicks of a substep as one: v becomes decay * v + gain * a.
struct WholeKick {
    double decay;
    double gain;
};

WholeKick whole_kick(const SubstepParams<double>& p, Features features) {
    const bool drag = features.has(Feature::drag);
    const double first = drag ? p.decay : 1.0;
    if (!features.has(Feature::velocity_verlet)) {
        return {first, p.gain};
    }
    const double second = drag ? p.second_decay : 1.0;
    return {first * second, second * p.gain + p.second_gain};
}

double wall_force(const SubstepParams<double>& p, Features features, double overlap, double separation_speed,
                  double mass, double zeta) {
    if (overlap <= 0.0) {
        return 0.0;
    }
    double force = p.stiffness * std::min(overlap, p.wall_depth);
    if (features.has(Feature::dashpot)) {
        double c = 2.0 * zeta * std::sqrt(p.stiffness * mass);
        if (features.has(Feature::semi_implicit)) {
            c /= 1.0 + p.damping_time * c / mass;
        }
        force -= c * separation_speed;
    }
    return features.has(Feature::limit_force) ? std::max(force, 0.0) : force;
}

// m/s^2: the hand that holds a ball.
dvec3 pull(const SubstepParams<double>& p, const dvec3& position, const dvec3& velocity) {
    return p.pull_rate * p.pull_rate * (p.pull_target - position) - 2.0 * p.pull_rate * velocity;
}

// N, on one ball.
dvec3 walls_force(const SubstepParams<double>& p, Features features, const vec4& position, const vec4& velocity,
                  double zeta, const Compensation& left_out) {
    dvec3 force(0.0);
    for (int axis = 0; features.has(Feature::walls) && axis < 3; ++axis) {
        const auto [low, high] = wall_overlaps(p, position, axis, left_out);
        const auto v = static_cast<double>(velocity[axis]);
        const auto mass = static_cast<double>(velocity.w);
        force[axis] = wall_force(p, features, low, v - p.lower_velocity[axis], mass, zeta) -
                      wall_force(p, features, high, p.upper_velocity[axis] - v, mass, zeta);
    }
    return force;
}

}  // namespace

Violation momentum_balanced(const SubstepParams<double>& params, Features features, std::span<const vec4> positions,
                            std::span<const vec4> velocities, std::span<const float> damping_ratios,
                            std::span<const vec4> next_velocities, std::span<const Compensation> compensations) {
    constexpr double ulp = std::numeric_limits<float>::epsilon();
    const WholeKick kick = whole_kick(params, features);
    const CollideBound bound = collide_bound(params, features, positions, velocities, damping_ratios, compensations);
    dvec3 unexplained(0.0);
    double tolerance = 0.0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (in_quarantine(positions[i])) {
            continue;
        }
        const auto mass = static_cast<double>(velocities[i].w);
        const double zeta =
            features.has(Feature::ball_restitution) ? static_cast<double>(damping_ratios[i]) : params.damping_ratio;
        const dvec3 before(velocities[i]);
        const dvec3 after(next_velocities[i]);
        const bool pulled = features.has(Feature::pull) && i == params.pull_ball;
        const dvec3 gravity = (features.has(Feature::gravity) ? params.gravity : dvec3(0.0)) +
                              (pulled ? pull(params, dvec3(positions[i]), before) : dvec3(0.0));
        const dvec3 walls = walls_force(params, features, positions[i], velocities[i], zeta,
                                        compensations.empty() ? Compensation{} : compensations[i]);
        unexplained += mass * (after - kick.decay * before) - kick.gain * (mass * gravity + walls);
        tolerance += mass * (bound.velocity[i] +
                             4.0 * ulp * (glm::length(before) + glm::length(after) + kick.gain * glm::length(gravity)));
    }
    const double off = glm::length(unexplained);
    if (std::isfinite(off) && off > tolerance) {
        return "the momentum changed by " + std::to_string(off) +
               " kg m/s that no wall, gravity, drag or hand explains (rounding: " + std::to_string(tolerance) + ")";
    }
    return std::nullopt;
}

}  // namespace ballpit::measure
