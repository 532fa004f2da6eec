#include "measure/float_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/quarantine.h"
#include "measure/pairs.h"

namespace ballpit::measure {

namespace {

// Every constant below is derived in docs/accuracy.md, "The bound"; each is the derived one or rounded up.
constexpr double ulp = std::numeric_limits<float>::epsilon();
constexpr double smallest_normal = std::numeric_limits<float>::min();

// Sums over the contacts of one ball.
struct Contacts {
    double uncertainty = 0.0;  // N, in units of ulp
    double force = 0.0;        // N, sum of magnitudes
    double count = 0.0;
};

// One contact as both balls, or ball and wall, see it. A wall has reach 0: its overlap needs no square root.
struct Contact {
    double reach;
    double overlap;
    double speed;
    double reduced_mass;
    double damping_ratio;
};

struct Bounder {
    const SubstepParams<double>& params;
    Features features;
    std::span<const vec4> positions;
    std::span<const vec4> velocities;
    std::span<const float> damping_ratios;
    std::span<const Compensation> compensations;

    double damping_ratio(std::size_t i) const {
        return features.has(Feature::ball_restitution) ? static_cast<double>(damping_ratios[i]) : params.damping_ratio;
    }

    void add(Contacts& sum, const Contact& contact) const {
        const double spring = params.stiffness * contact.overlap;
        const double c = features.has(Feature::dashpot)
                             ? 2.0 * contact.damping_ratio * std::sqrt(params.stiffness * contact.reduced_mass)
                             : 0.0;
        const double dashpot = c * contact.speed;
        sum.uncertainty += 8.0 * params.stiffness * contact.reach + 16.0 * spring + 32.0 * dashpot;
        sum.force += spring + dashpot;
        sum.count += 1.0;
    }

    void add_pair(std::vector<Contacts>& contacts, const Pair& pair) const {
        const vec4& a = positions[pair.a];
        const vec4& b = positions[pair.b];
        const double reach = static_cast<double>(a.w) + static_cast<double>(b.w);
        const auto mass_a = static_cast<double>(velocities[pair.a].w);
        const auto mass_b = static_cast<double>(velocities[pair.b].w);
        const Contact contact{reach, std::max(0.0, reach - glm::distance(dvec3(a), dvec3(b))),
                              glm::distance(dvec3(velocities[pair.a]), dvec3(velocities[pair.b])),
                              mass_a * mass_b / (mass_a + mass_b),
                              std::max(damping_ratio(pair.a), damping_ratio(pair.b))};
        add(contacts[pair.a], contact);
        add(contacts[pair.b], contact);
    }

    void add_walls(Contacts& sum, std::size_t i) const {
        const Compensation left_out = compensations.empty() ? Compensation{} : compensations[i];
        for (int axis = 0; axis < 3; ++axis) {
            const double wall_speed =
                std::max(std::abs(params.lower_velocity[axis]), std::abs(params.upper_velocity[axis]));
            const double speed = std::abs(static_cast<double>(velocities[i][axis])) + wall_speed;
            for (const double overlap : wall_overlaps(params, positions[i], axis, left_out)) {
                if (overlap > 0.0) {
                    add(sum, {0.0, overlap, speed, static_cast<double>(velocities[i].w), damping_ratio(i)});
                }
            }
        }
    }

    // m/s^2, both terms of the hand's spring.
    double pull(std::size_t i) const {
        return params.pull_rate *
               (params.pull_rate * (glm::length(params.pull_target) + glm::length(dvec3(positions[i]))) +
                2.0 * glm::length(dvec3(velocities[i])));
    }

    struct Errors {
        double position;
        double velocity;
        double compensation;
    };

    Errors errors(const Contacts& sum, std::size_t i) const {
        constexpr double underflow = 16.0 * smallest_normal;
        const bool pulled = features.has(Feature::pull) && i == params.pull_ball;
        if (sum.count == 0.0 && !pulled) {
            return {underflow, underflow, underflow};  // free flight: no division but 0 / mass, so both sides agree
        }
        const auto mass = static_cast<double>(velocities[i].w);
        const double gravity = features.has(Feature::gravity) ? glm::length(params.gravity) : 0.0;
        const double acceleration = sum.force / mass + gravity + (pulled ? pull(i) : 0.0);
        const double force_error = ulp * (sum.uncertainty + 2.0 * (sum.count + 2.0) * sum.force);
        const double acceleration_error = force_error / mass + 6.0 * ulp * acceleration;
        const double gain = params.gain + params.second_gain;
        const double drift = params.drift;
        const double speed = glm::length(dvec3(velocities[i])) + std::max(gain, drift) * acceleration;
        const double velocity_error = gain * acceleration_error + 6.0 * ulp * speed + underflow;
        const double position_error = drift * (velocity_error + drift * acceleration_error) +
                                      3.0 * ulp * (glm::length(dvec3(positions[i])) + drift * speed) + underflow;
        // Each is at most half an ulp of what it belongs to, whichever way that was rounded.
        const double compensation_error =
            ulp * std::max(glm::length(dvec3(positions[i])) + drift * speed, speed) + underflow;
        return {position_error, velocity_error, compensation_error};
    }
};

}  // namespace

std::array<double, 2> wall_overlaps(const SubstepParams<double>& params, const vec4& position, int axis,
                                    const Compensation& left_out) {
    const float left = axis == 0 ? left_out.x : axis == 1 ? left_out.y : left_out.z;
    const float low = position.w - (position[axis] - static_cast<float>(params.box_lower[axis]));
    const float high = position.w - (static_cast<float>(params.box_upper[axis]) - position[axis]);
    return {static_cast<double>(low - left), static_cast<double>(high + left)};
}

CollideBound collide_bound(const SubstepParams<double>& params, Features features, std::span<const vec4> positions,
                           std::span<const vec4> velocities, std::span<const float> damping_ratios,
                           std::span<const Compensation> compensations) {
    const Bounder bounder{params, features, positions, velocities, damping_ratios, compensations};
    std::vector<Contacts> contacts(positions.size());
    if (features.has(Feature::contact)) {
        for (const Pair& pair : touching_pairs(positions)) {
            bounder.add_pair(contacts, pair);
        }
    }
    CollideBound bound;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (features.has(Feature::walls) && !in_quarantine(positions[i])) {
            bounder.add_walls(contacts[i], i);
        }
        const Bounder::Errors errors = bounder.errors(contacts[i], i);
        bound.position.push_back(errors.position);
        bound.velocity.push_back(errors.velocity);
        if (features.has(Feature::compensated)) {
            bound.compensation.push_back(errors.compensation);
        }
    }
    return bound;
}

}  // namespace ballpit::measure
