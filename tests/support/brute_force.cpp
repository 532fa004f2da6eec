#include "support/brute_force.h"

#include <algorithm>
#include <cmath>

#include "core/contact.h"

namespace ballpit::test {

namespace {

struct Law {
    Features features;
    const Settings& settings;
    std::vector<double> zetas;  // damping ratio of each ball
    double wall_depth = 0.0;    // m: the largest diameter, where nothing has weight

    Law(const BallState& state, Features laws, const Settings& given) : features(laws), settings(given) {
        for (const vec4& position : state.positions) {
            wall_depth = std::max(wall_depth, 2.0 * static_cast<double>(position.w));
        }
        const double common = damping_ratio_from_restitution(settings.restitution, settings.limit_force);
        zetas.assign(state.count(), common);
        for (std::size_t i = 0; features.has(Feature::ball_restitution) && i < zetas.size(); ++i) {
            zetas[i] = damping_ratio_from_restitution(static_cast<double>(state.restitutions[i]), settings.limit_force);
        }
    }

    // Adds the force of one contact along `normal`, which points to the ball.
    void push(ExpectedBall& ball, dvec3& force, const dvec3& normal, double overlap, double separation_speed,
              double mass, double damping_ratio) const {
        const double spring = settings.stiffness * overlap;
        const double c = 2.0 * damping_ratio * std::sqrt(settings.stiffness * mass);
        const double dashpot = features.has(Feature::dashpot) ? c * separation_speed : 0.0;
        double size = spring - dashpot;
        if (features.has(Feature::limit_force) && size < 0.0) {
            size = 0.0;
        }
        force += size * normal;
        ball.force_scale += spring + std::abs(dashpot);
        ++ball.contacts;
    }
};

void add_pairs(const BallState& state, std::size_t i, const Law& law, ExpectedBall& ball, dvec3& force) {
    const dvec3 position(state.positions[i]);
    const auto mass = static_cast<double>(state.velocities[i].w);
    for (std::size_t other = 0; other < state.count(); ++other) {
        const dvec3 offset = position - dvec3(state.positions[other]);
        const double distance = glm::length(offset);
        const double reach = static_cast<double>(state.positions[i].w) + static_cast<double>(state.positions[other].w);
        if (other == i || !(distance < reach)) {
            continue;
        }
        if (distance == 0.0) {
            ball.coincident = true;
            continue;
        }
        const auto other_mass = static_cast<double>(state.velocities[other].w);
        const dvec3 normal = offset / distance;
        const double speed = glm::dot(dvec3(state.velocities[i]) - dvec3(state.velocities[other]), normal);
        law.push(ball, force, normal, reach - distance, speed, 1.0 / (1.0 / mass + 1.0 / other_mass),
                 std::max(law.zetas[i], law.zetas[other]));
    }
}

void add_walls(const BallState& state, std::size_t i, const Law& law, const dvec3& half_extent, ExpectedBall& ball,
               dvec3& force) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            dvec3 inward(0.0);
            inward[axis] = -side;
            const double gap = half_extent[axis] - side * static_cast<double>(state.positions[i][axis]);
            const double overlap = static_cast<double>(state.positions[i].w) - gap;
            if (overlap > 0.0) {
                law.push(ball, force, inward, std::min(overlap, law.wall_depth),
                         glm::dot(dvec3(state.velocities[i]), inward), static_cast<double>(state.velocities[i].w),
                         law.zetas[i]);
            }
        }
    }
}

}  // namespace

std::vector<ExpectedBall> brute_force_substep(const BallState& state, Features features, const Settings& settings,
                                              const dvec3& half_extent, double dt) {
    const Law law(state, features, settings);
    std::vector<ExpectedBall> expected(state.count());
    for (std::size_t i = 0; i < state.count(); ++i) {
        ExpectedBall& ball = expected[i];
        dvec3 force(0.0);
        if (features.has(Feature::contact)) {
            add_pairs(state, i, law, ball, force);
        }
        if (features.has(Feature::walls)) {
            add_walls(state, i, law, half_extent, ball, force);
        }
        const dvec3 a = force / static_cast<double>(state.velocities[i].w) +
                        (features.has(Feature::gravity) ? settings.gravity : dvec3(0.0));
        const dvec3 v0(state.velocities[i]);
        const bool half =
            settings.integrator == Integrator::leapfrog || settings.integrator == Integrator::velocity_verlet;
        const double time = half ? 0.5 * dt : dt;
        const double drag = features.has(Feature::drag) ? settings.drag : 0.0;
        const double gain = drag == 0.0 ? time : (1.0 - std::exp(-drag * time)) / drag;
        ball.velocity = std::exp(-drag * time) * v0 + gain * a;
        dvec3 drift = ball.velocity;
        if (settings.integrator == Integrator::forward_euler) {
            drift = v0;
        } else if (settings.integrator == Integrator::historical) {
            drift = v0 + 0.5 * dt * a;
        }
        ball.position = dvec3(state.positions[i]) + dt * drift;
    }
    return expected;
}

}  // namespace ballpit::test
