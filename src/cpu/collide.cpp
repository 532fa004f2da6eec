#include "cpu/collide.h"

#include <algorithm>
#include <cmath>

#include "cpu/assign_cells.h"

namespace ballpit::cpu {

namespace {

// One ball, as the sums of one thread see it.
template <class Real>
struct Ball {
    std::uint32_t id;
    Vec3<Real> position;
    Real radius;
    Vec3<Real> velocity;
    Real mass;
    Real damping_ratio;
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

template <class Real>
struct Collider {
    const SubstepParams<Real>& params;
    const Features features;
    const CollideInput<Real>& in;

    Real radius_of(const Vec4<Real>& position) const {
        return features.has(Feature::unequal_radii) ? position.w : params.radius;
    }
    Real mass_of(const Vec4<Real>& velocity) const {
        return features.has(Feature::unequal_masses) ? velocity.w : params.mass;
    }
    Real damping_ratio_of(std::uint32_t id) const {
        return features.has(Feature::ball_restitution) ? in.damping_ratios[id] : params.damping_ratio;
    }

    Ball<Real> ball(std::uint32_t id) const {
        const Vec4<Real>& p = in.positions[id];
        const Vec4<Real>& v = in.velocities[id];
        return {id, Vec3<Real>(p), radius_of(p), Vec3<Real>(v), mass_of(v), damping_ratio_of(id)};
    }

    // Force (N) along the contact normal: F = k * overlap - c * separation_speed.
    Real damped_force(Real overlap, Real separation_speed, Real reduced_mass, Real damping_ratio) const {
        const Real c = Real(2) * damping_ratio * std::sqrt(params.stiffness * reduced_mass);
        const Real force = params.stiffness * overlap - c * separation_speed;
        return features.has(Feature::limit_force) ? std::max(force, Real(0)) : force;
    }

    // Of the other ball only the position is read, until it is known to touch; without a dashpot, nothing else at all.
    Real pair_force(const Ball<Real>& a, std::uint32_t other, const Vec3<Real>& normal, Real overlap) const {
        if (!features.has(Feature::dashpot)) {
            return params.stiffness * overlap;
        }
        const Vec4<Real>& velocity = in.velocities[other];
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
        if (!(distance_squared < reach * reach)) {
            return;
        }
        const Real distance = std::sqrt(distance_squared);
        const Vec3<Real> normal = distance_squared > 0 ? offset / distance : coincident_direction<Real>(a.id, other);
        force += pair_force(a, other, normal, reach - distance) * normal;
    }

    void add_neighbours(const Ball<Real>& a, Vec3<Real>& force) const;

    // `speed`: of the ball away from the wall.
    Real wall_force(const Ball<Real>& ball, Real overlap, Real speed) const {
        if (!(overlap > 0)) {
            return 0;
        }
        return features.has(Feature::dashpot) ? damped_force(overlap, speed, ball.mass, ball.damping_ratio)
                                              : params.stiffness * overlap;
    }

    // Walls are half-spaces: the deeper the ball, the stronger the push, on both sides of the box.
    void add_walls(const Ball<Real>& ball, Vec3<Real>& force) const {
        const bool moving = features.has(Feature::moving_walls);
        const Vec3<Real> from_low = moving ? ball.velocity - params.lower_velocity : ball.velocity;
        const Vec3<Real> from_high = moving ? ball.velocity - params.upper_velocity : ball.velocity;
        for (int axis = 0; axis < 3; ++axis) {
            const Real low = ball.radius - (ball.position[axis] - params.box_lower[axis]);
            const Real high = ball.radius - (params.box_upper[axis] - ball.position[axis]);
            force[axis] += wall_force(ball, low, from_low[axis]);
            force[axis] -= wall_force(ball, high, -from_high[axis]);
        }
    }

    Vec3<Real> acceleration(const Ball<Real>& ball) const {
        Vec3<Real> a(0);
        if (features.has(Feature::contact) || features.has(Feature::walls)) {
            Vec3<Real> force(0);
            if (features.has(Feature::contact)) {
                add_neighbours(ball, force);
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

    Vec3<Real> kick(const Vec3<Real>& v, const Vec3<Real>& a, Real decay, Real gain) const {
        return features.has(Feature::drag) ? decay * v + gain * a : v + gain * a;
    }
};

template <class Real>
void Collider<Real>::add_neighbours(const Ball<Real>& a, Vec3<Real>& force) const {
    if (features.has(Feature::brute_force)) {
        for (std::uint32_t id = 0; id < params.ball_count; ++id) {
            if (id != a.id) {
                add_pair(a, id, force);
            }
        }
        return;
    }
    const uvec3 middle = cell_coordinates(params, a.position);
    const uvec3 low = middle - glm::min(middle, uvec3(1));
    const uvec3 high = glm::min(middle + 1u, params.grid_cells - 1u);
    for (std::uint32_t z = low.z; z <= high.z; ++z) {
        for (std::uint32_t y = low.y; y <= high.y; ++y) {
            for (std::uint32_t x = low.x; x <= high.x; ++x) {
                const CellRange range = in.cell_ranges[(z * params.grid_cells.y + y) * params.grid_cells.x + x];
                for (std::uint32_t slot = range.first; slot < range.end; ++slot) {
                    const std::uint32_t id = in.keys[slot].ball_id;
                    if (id != a.id) {
                        add_pair(a, id, force);
                    }
                }
            }
        }
    }
}

template <class Real>
bool is_finite(const Vec3<Real>& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

template <class Real>
void collide(const SubstepParams<Real>& params, Features features, const CollideInput<Real>& in,
             std::span<Vec4<Real>> next_positions, std::span<Vec4<Real>> next_velocities, Status& status) {
    const Collider<Real> collider{params, features, in};
    for (std::uint32_t id = 0; id < params.ball_count; ++id) {
        const Ball<Real> ball = collider.ball(id);
        const Vec3<Real> a = collider.acceleration(ball);
        Vec3<Real> v = collider.kick(ball.velocity, a, params.decay, params.gain);
        if (features.has(Feature::velocity_verlet)) {
            v = collider.kick(v, a, params.second_decay, params.second_gain);
        }
        Vec3<Real> x = ball.position;
        if (features.has(Feature::forward_euler)) {
            x = x + params.drift * ball.velocity;
        } else if (features.has(Feature::historical)) {
            x = x + (params.drift * ball.velocity + (Real(0.5) * params.drift * params.drift) * a);
        } else {
            x = x + params.drift * v;
        }
        if (features.has(Feature::diagnostics) && (!is_finite(x) || !is_finite(v))) {
            status.bits |= STATUS_NOT_FINITE;
            ++status.not_finite;
        }
        next_positions[id] = Vec4<Real>(x, in.positions[id].w);
        next_velocities[id] = Vec4<Real>(v, in.velocities[id].w);
    }
}

template void collide(const SubstepParams<float>&, Features, const CollideInput<float>&, std::span<Vec4<float>>,
                      std::span<Vec4<float>>, Status&);
template void collide(const SubstepParams<double>&, Features, const CollideInput<double>&, std::span<Vec4<double>>,
                      std::span<Vec4<double>>, Status&);

}  // namespace ballpit::cpu
