// What collide does with one ball, for whoever decides in which order balls are looked at and neighbours found.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/quarantine.h"
#include "cpu/collide.h"

namespace ballpit::cpu {

// One ball, as the sums of one thread see it.
template <class Real>
struct Ball {
    std::uint32_t id;
    Vec3<Real> position;
    Real radius;
    Vec3<Real> velocity;
    Real mass;
    Real damping_ratio;
    Vec3<Real> left_out;  // of the position
};

template <class Real>
Real dot(const Vec3<Real>& a, const Vec3<Real>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;  // in the shader's order of additions
}

// Balls with the same centre have no line of centres. Both of a pair derive one axis from their ids and take
// opposite ends of it, so that momentum is still conserved.
template <class Real>
Vec3<Real> coincident_direction(std::uint32_t id, std::uint32_t other) {
    Vec3<Real> direction(0);
    direction[static_cast<int>((id + other) % 3u)] = id < other ? Real(1) : Real(-1);
    return direction;
}

// Adds the increment and what earlier sums have left out; leaves out what this one does.
template <class Real>
Vec3<Real> compensated_sum(const Vec3<Real>& sum, const Vec3<Real>& increment, Vec3<Real>& left_out) {
    const Vec3<Real> added = increment + left_out;
    const Vec3<Real> rounded = sum + added;
    const Vec3<Real> moved = rounded - sum;
    left_out = (sum - (rounded - moved)) + (added - moved);
    return rounded;
}

// A ball that moves by more than its radius in a substep may miss what is in its way.
template <class Real>
bool too_fast(const Vec3<Real>& way, Real radius) {
    return dot(way, way) > radius * radius;
}

template <class Real>
struct Collider {
    const SubstepParams<Real>& params;
    const Features features;
    const CollideInput<Real>& in;
    Status& status;  // nobody looks at it without diagnostics

    void count(std::uint32_t bit, std::uint32_t Status::*counter) const {
        status.bits |= bit;
        ++(status.*counter);
    }

    Real radius_of(const Vec4<Real>& position) const {
        return features.has(Feature::unequal_radii) ? position.w : params.radius;
    }
    Real mass_of(const Vec4<Real>& velocity) const {
        return features.has(Feature::unequal_masses) ? velocity.w : params.mass;
    }
    Real damping_ratio_of(std::uint32_t id) const {
        return features.has(Feature::ball_restitution) ? in.damping_ratios[id] : params.damping_ratio;
    }

    Ball<Real> ball(std::uint32_t id, const Vec3<Real>& left_out) const {
        const Vec4<Real>& p = in.positions[id];
        const Vec4<Real>& v = in.velocities[id];
        return {id, Vec3<Real>(p), radius_of(p), Vec3<Real>(v), mass_of(v), damping_ratio_of(id), left_out};
    }

    // N s/m: 2 zeta sqrt(k m_eff), or so much of it as a substep can follow (core/contact.h).
    Real dashpot(Real damping_ratio, Real reduced_mass) const {
        const Real c = Real(2) * damping_ratio * std::sqrt(params.stiffness * reduced_mass);
        return features.has(Feature::semi_implicit) ? c / (Real(1) + params.damping_time * c / reduced_mass) : c;
    }

    // Force (N) along the contact normal: F = k * overlap - c * separation_speed.
    Real damped_force(Real overlap, Real separation_speed, Real reduced_mass, Real damping_ratio) const {
        const Real c = dashpot(damping_ratio, reduced_mass);
        const Real force = params.stiffness * overlap - c * separation_speed;
        return features.has(Feature::limit_force) ? std::max(force, Real(0)) : force;
    }

    // Of the other ball only the position is read, until it is known to touch; without a dashpot, nothing else at all.
    Real pair_force(const Ball<Real>& a, std::uint32_t other, const Vec3<Real>& normal, Real overlap) const {
        if (!features.has(Feature::dashpot)) {
            return params.stiffness * overlap;
        }
        const Vec4<Real>& velocity = in.velocities[other];
        if (features.has(Feature::diagnostics) && !can_be_squared(Vec3<Real>(velocity))) {
            return 0;  // it goes into quarantine in this very substep
        }
        const Real mass = mass_of(velocity);
        const Real reduced_mass = a.mass * mass / (a.mass + mass);
        const Real speed = dot(a.velocity - Vec3<Real>(velocity), normal);
        return damped_force(overlap, speed, reduced_mass, std::max(a.damping_ratio, damping_ratio_of(other)));
    }

    void add_pair(const Ball<Real>& a, std::uint32_t other, Vec3<Real>& force) const {
        const Vec4<Real>& position = in.positions[other];
        const Vec3<Real> offset = a.position - Vec3<Real>(position);
        const Real reach = a.radius + radius_of(position);
        const Real distance_squared = dot(offset, offset);
        const bool diagnosed = features.has(Feature::diagnostics);
        if (!(distance_squared < reach * reach) || (diagnosed && in_quarantine(position))) {
            return;
        }
        if (diagnosed && distance_squared == 0 && a.id < other) {
            count(STATUS_COINCIDENT, &Status::coincident);
        }
        const Real distance = std::sqrt(distance_squared);
        const Vec3<Real> normal = distance_squared > 0 ? offset / distance : coincident_direction<Real>(a.id, other);
        force += pair_force(a, other, normal, reach - distance) * normal;
    }

    // `speed`: of the ball away from the wall.
    Real wall_force(const Ball<Real>& ball, Real overlap, Real speed) const {
        if (!(overlap > 0)) {
            return 0;
        }
        const Real depth = std::min(overlap, params.wall_depth);
        if (features.has(Feature::diagnostics) && depth < overlap) {
            count(STATUS_CAPPED_WALL, &Status::capped_walls);
        }
        return features.has(Feature::dashpot) ? damped_force(depth, speed, ball.mass, ball.damping_ratio)
                                              : params.stiffness * depth;
    }

    // Walls are half-spaces: the deeper the ball, the stronger the push, on both sides of the box, up to wall_depth.
    void add_walls(const Ball<Real>& ball, Vec3<Real>& force) const {
        const bool moving = features.has(Feature::moving_walls);
        const Vec3<Real> from_low = moving ? ball.velocity - params.lower_velocity : ball.velocity;
        const Vec3<Real> from_high = moving ? ball.velocity - params.upper_velocity : ball.velocity;
        for (int axis = 0; axis < 3; ++axis) {
            Real low = ball.radius - (ball.position[axis] - params.box_lower[axis]);
            Real high = ball.radius - (params.box_upper[axis] - ball.position[axis]);
            if (features.has(Feature::compensated)) {  // a wall's place is exact, so the ball's may be, too
                low -= ball.left_out[axis];
                high += ball.left_out[axis];
            }
            force[axis] += wall_force(ball, low, from_low[axis]);
            force[axis] -= wall_force(ball, high, -from_high[axis]);
        }
    }

    // contact_force(ball): the sum (N) over its neighbours; asked for only where balls touch each other.
    template <class ContactForce>
    Vec3<Real> acceleration(const Ball<Real>& ball, const ContactForce& contact_force) const {
        Vec3<Real> a(0);
        if (features.has(Feature::contact) || features.has(Feature::walls)) {
            Vec3<Real> force(0);
            if (features.has(Feature::contact)) {
                force = contact_force(ball);
            }
            if (features.has(Feature::walls)) {
                add_walls(ball, force);
            }
            a = force / ball.mass;
        }
        if (features.has(Feature::gravity)) {
            a = a + params.gravity;
        }
        if (features.has(Feature::pull) && ball.id == params.pull_ball) {
            a = a + (params.pull_rate * params.pull_rate) * (params.pull_target - ball.position);
            a = a - (Real(2) * params.pull_rate) * ball.velocity;
        }
        return a;
    }

    // One of the two kicks of a substep: v becomes decay * v + gain * a.
    struct Kick {
        Real decay;
        Real decay_change;
        Real gain;
    };

    Vec3<Real> kicked(const Vec3<Real>& v, const Vec3<Real>& a, const Kick& kick, Vec3<Real>& left_out) const {
        const bool drag = features.has(Feature::drag);
        if (features.has(Feature::compensated)) {
            return compensated_sum<Real>(v, drag ? kick.decay_change * v + kick.gain * a : kick.gain * a, left_out);
        }
        return drag ? kick.decay * v + kick.gain * a : v + kick.gain * a;
    }

    // `v`: after the kicks.
    Vec3<Real> way(const Ball<Real>& ball, const Vec3<Real>& v, const Vec3<Real>& a) const {
        if (features.has(Feature::forward_euler)) {
            return params.drift * ball.velocity;
        }
        if (features.has(Feature::historical)) {
            return params.drift * ball.velocity + (Real(0.5) * params.drift * params.drift) * a;
        }
        return params.drift * v;
    }

    // The next state of one ball; `contact_force` as acceleration() has it.
    template <class ContactForce>
    void advance(std::uint32_t id, const CollideOutput<Real>& out, const ContactForce& contact_force) const {
        const bool compensated = features.has(Feature::compensated);
        const bool diagnosed = features.has(Feature::diagnostics);
        const bool springs = features.has(Feature::contact) || features.has(Feature::walls);
        Real radius = in.positions[id].w;
        if (diagnosed && in_quarantine(in.positions[id])) {
            out.next_positions[id] = in.positions[id];
            out.next_velocities[id] = in.velocities[id];
            return;
        }
        LeftOut<Real> unkept;
        LeftOut<Real>& left = compensated ? out.left_out[id] : unkept;
        const Ball<Real> ball = this->ball(id, left.position);
        const Vec3<Real> a = acceleration(ball, contact_force);
        Vec3<Real> v = kicked(ball.velocity, a, {params.decay, params.decay_change, params.gain}, left.velocity);
        if (features.has(Feature::velocity_verlet)) {
            v = kicked(v, a, {params.second_decay, params.second_decay_change, params.second_gain}, left.velocity);
        }
        const Vec3<Real> way = this->way(ball, v, a);
        Vec3<Real> x = compensated ? compensated_sum<Real>(ball.position, way, left.position) : ball.position + way;
        if (diagnosed && (!can_be_squared(x) || !can_be_squared(v))) {
            count(STATUS_NOT_FINITE, &Status::not_finite);
            status.quarantined_ball = std::max(status.quarantined_ball, id + 1);
            x = last_place(ball.position, params.box_lower);
            v = Vec3<Real>(0);
            left = {};
            radius = -radius;
        } else if (diagnosed && springs && too_fast(way, radius)) {
            count(STATUS_TOO_FAST, &Status::too_fast);
        }
        out.next_positions[id] = Vec4<Real>(x, radius);
        out.next_velocities[id] = Vec4<Real>(v, in.velocities[id].w);
    }
};

}  // namespace ballpit::cpu
