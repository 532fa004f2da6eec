#include "cpu/meter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/quarantine.h"
#include "core/wall_depth.h"
#include "cpu/neighbours.h"

namespace ballpit::cpu {

namespace {

using Values = std::array<double, METER_VALUES>;

// Largest eigenvalue of a symmetric, positive matrix, by Jacobi's rotations (1846): not the closed form of the shader.
double largest_eigenvalue(glm::dmat3 s) {
    for (int sweep = 0; sweep < 12; ++sweep) {
        for (int p = 0; p < 2; ++p) {
            for (int q = p + 1; q < 3; ++q) {
                if (s[p][q] == 0.0) {
                    continue;
                }
                const double angle = 0.5 * std::atan2(2.0 * s[p][q], s[p][p] - s[q][q]);
                glm::dmat3 turn(1.0);
                turn[p][p] = turn[q][q] = std::cos(angle);
                turn[q][p] = std::sin(angle);
                turn[p][q] = -std::sin(angle);
                s = turn * s * glm::transpose(turn);
            }
        }
    }
    return std::max({s[0][0], s[1][1], s[2][2]});
}

struct Ball {
    std::uint32_t id;
    dvec3 position;
    double radius;
    dvec3 velocity;
    double mass;
    double zeta;
    dvec3 synchronised;  // velocity at the time of the position
};

// By springs (N/m) and dashpots (N s/m), along any direction.
struct Held {
    glm::dmat3 stiffness{0.0};
    glm::dmat3 damping{0.0};
};

template <class Real>
struct Meter {
    const SubstepParams<Real>& params;
    const Features features;
    const Synchronisation& synchronisation;
    const MeterInput<Real>& in;
    Values total{};

    static double wide(Real value) { return static_cast<double>(value); }

    Ball ball(std::uint32_t id) const {
        const Vec4<Real>& p = in.positions[id];
        const Vec4<Real>& v = in.velocities[id];
        const Real zeta = features.has(Feature::ball_restitution) ? in.damping_ratios[id] : params.damping_ratio;
        Ball ball{id, dvec3(p), wide(p.w), dvec3(v), wide(v.w), wide(zeta), dvec3(0.0)};
        if (features.has(Feature::contact)) {
            ball.synchronised = synchronisation.old_velocity * ball.velocity +
                                synchronisation.new_velocity * dvec3(in.next_velocities[id]);
        }
        return ball;
    }

    // N s/m, as collide has it.
    double dashpot(double zeta, double reduced_mass) const {
        const double c = 2.0 * zeta * std::sqrt(wide(params.stiffness) * reduced_mass);
        return features.has(Feature::semi_implicit) ? c / (1.0 + wide(params.damping_time) * c / reduced_mass) : c;
    }

    // None of the balls any more, or just about to be none.
    bool is_out(std::uint32_t id) const {
        const Vec4<Real>& p = in.positions[id];
        return in_quarantine(p) || !can_be_squared(Vec3<Real>(p)) || !can_be_squared(Vec3<Real>(in.velocities[id]));
    }

    double force(double overlap, double speed, double reduced_mass, double zeta) const {
        const double spring = wide(params.stiffness) * overlap;
        if (!features.has(Feature::dashpot)) {
            return spring;
        }
        const double force = spring - dashpot(zeta, reduced_mass) * speed;
        return features.has(Feature::limit_force) ? std::max(force, 0.0) : force;
    }

    // A pair is met from both ends: `share` is 1/2, at walls 1.
    void add_contact(double overlap, double diameter, double share, const dvec3& normal, double zeta,
                     double reduced_mass, Held& held) {
        const double k = wide(params.stiffness);
        total[METER_OVERLAP_SHARES] += share * overlap / diameter;
        largest(METER_OVERLAP, overlap);
        largest(METER_OVERLAP_SHARE, overlap / diameter);
        if (features.has(Feature::dashpot)) {
            const double c = dashpot(zeta, reduced_mass);
            held.damping += glm::outerProduct(normal, c / share * normal);
        }
        held.stiffness += glm::outerProduct(normal, k / share * normal);
    }

    void largest(std::size_t value, double candidate) { total[value] = std::max(total[value], candidate); }

    void add_pair(const Ball& a, std::uint32_t other, Held& held) {
        const Vec4<Real> offset = in.positions[a.id] - in.positions[other];
        const Real reach = in.positions[a.id].w + in.positions[other].w;
        const Real squared = offset.x * offset.x + offset.y * offset.y + offset.z * offset.z;
        if (!(squared < reach * reach) || is_out(other)) {
            return;
        }
        const Real distance = std::sqrt(squared);
        dvec3 normal = dvec3(offset) / wide(distance);
        if (squared == 0) {  // as collide's coincident_direction()
            normal = dvec3(0.0);
            normal[static_cast<int>((a.id + other) % 3u)] = a.id < other ? 1.0 : -1.0;
        }
        const double overlap = wide(reach - distance);
        const Ball b = ball(other);
        const double reduced_mass = a.mass * b.mass / (a.mass + b.mass);
        const double zeta = std::max(a.zeta, b.zeta);
        add_contact(overlap, wide(reach), 0.5, normal, zeta, reduced_mass, held);
        total[METER_ELASTIC] += 0.25 * wide(params.stiffness) * overlap * overlap;
        const double missing = wide(params.stiffness) * overlap -
                               force(overlap, glm::dot(a.velocity - b.velocity, normal), reduced_mass, zeta);
        total[METER_CONTACT_HEAT] += 0.5 * missing * glm::dot(a.synchronised - b.synchronised, normal);
        total[METER_CONTACT_ENDS] += 1.0;
    }

    void add_neighbours(const Ball& a, Held& held) {
        for_each_neighbour(params, features, in.keys, in.cell_ranges, Vec3<Real>(in.positions[a.id]), a.id,
                           [&](std::uint32_t other) { add_pair(a, other, held); });
    }

    // One of the six walls: normal into the box along `axis` with `side` 1 (lower) or -1.
    struct Wall {
        int axis;
        double side;
        double overlap;
        double force;
        double wall_speed;  // along the normal
    };

    double held_depth(const Wall& wall) const { return std::min(wall.overlap, wide(params.wall_depth)); }

    std::array<Wall, 6> walls(const Ball& ball) const {
        std::array<Wall, 6> walls{};
        for (int axis = 0; axis < 3; ++axis) {
            const Real position = in.positions[ball.id][axis];
            const Real radius = in.positions[ball.id].w;
            const Real low = radius - (position - params.box_lower[axis]);
            const Real high = radius - (params.box_upper[axis] - position);
            const std::size_t place = 2 * static_cast<std::size_t>(axis);
            walls[place] = {axis, 1.0, wide(low), 0.0, wide(params.lower_velocity[axis])};
            walls[place + 1] = {axis, -1.0, wide(high), 0.0, -wide(params.upper_velocity[axis])};
        }
        for (Wall& wall : walls) {
            if (wall.overlap > 0.0) {
                wall.force = force(held_depth(wall), wall.side * ball.velocity[wall.axis] - wall.wall_speed, ball.mass,
                                   ball.zeta);
            }
        }
        return walls;
    }

    void add_wall(const Ball& ball, const Wall& wall, Held& held) {
        if (!(wall.overlap > 0.0)) {
            return;
        }
        dvec3 normal(0.0);
        normal[wall.axis] = wall.side;
        add_contact(wall.overlap, 2.0 * ball.radius, 1.0, normal, ball.zeta, ball.mass, held);
        const double speed = glm::dot(ball.synchronised, normal) - wall.wall_speed;
        const double k = wide(params.stiffness);
        total[METER_ELASTIC] += capped_spring_energy(k, wall.overlap, wide(params.wall_depth));
        total[METER_WALL_CONTACTS] += 1.0;
        total[METER_WALL_HEAT] += (k * held_depth(wall) - wall.force) * speed;
        total[METER_WALL_WORK] += wall.force * wall.wall_speed;
        if (wall.axis == 2 && wall.side > 0.0) {
            total[METER_FLOOR_FORCE] += wall.force;
        }
    }

    void add_ball(std::uint32_t id) {
        if (is_out(id)) {
            return;
        }
        Ball a = ball(id);
        Held held;
        const bool has_walls = features.has(Feature::walls);
        const std::array<Wall, 6> walls = has_walls ? this->walls(a) : std::array<Wall, 6>{};
        dvec3 pull(0.0);
        if (features.has(Feature::pull) && id == params.pull_ball) {
            const double rate = wide(params.pull_rate);
            pull = a.mass * (rate * rate * (dvec3(params.pull_target) - a.position) - 2.0 * rate * a.velocity);
        }
        if (features.has(Feature::contact)) {
            add_neighbours(a, held);
        } else {
            dvec3 force = pull;
            for (const Wall& wall : walls) {
                force[wall.axis] += wall.side * wall.force;
            }
            const dvec3 gravity = features.has(Feature::gravity) ? dvec3(params.gravity) : dvec3(0.0);
            a.synchronised =
                synchronisation.old_velocity * a.velocity + synchronisation.acceleration * (force / a.mass + gravity);
        }
        for (const Wall& wall : walls) {
            add_wall(a, wall, held);
        }
        add_motion(a, pull, held);
    }

    void add_motion(const Ball& a, const dvec3& pull, const Held& held) {
        const dvec3 momentum = a.mass * a.synchronised;
        const dvec3 centre = 0.5 * (dvec3(params.box_lower) + dvec3(params.box_upper));
        const dvec3 angular = glm::cross(a.position - centre, momentum);
        const double speed = glm::length(a.synchronised);
        total[METER_KINETIC] += 0.5 * glm::dot(momentum, a.synchronised);
        if (features.has(Feature::gravity)) {
            total[METER_POTENTIAL] -= a.mass * glm::dot(dvec3(params.gravity), a.position);
        }
        total[METER_HAND_WORK] += glm::dot(pull, a.synchronised);
        for (int axis = 0; axis < 3; ++axis) {
            total[static_cast<std::size_t>(METER_MOMENTUM + axis)] += momentum[axis];
            total[static_cast<std::size_t>(METER_ANGULAR_MOMENTUM + axis)] += angular[axis];
        }
        total[METER_MASS] += a.mass;
        largest(METER_SPEED, speed);
        largest(METER_STIFFNESS, largest_eigenvalue(held.stiffness) / a.mass);
        largest(METER_DAMPING, largest_eigenvalue(held.damping) / a.mass);
        largest(METER_SPEED_SHARE, speed / (2.0 * a.radius));
        largest(METER_LIGHTNESS, 1.0 / a.mass);
    }
};

}  // namespace

template <class Real>
MeterReading meter(const SubstepParams<Real>& params, Features features, const Synchronisation& synchronisation,
                   const MeterInput<Real>& in) {
    Meter<Real> meter{params, features, synchronisation, in};
    for (std::uint32_t id = 0; id < params.ball_count; ++id) {
        meter.add_ball(id);
    }
    return reading_of(meter.total);
}

template MeterReading meter(const SubstepParams<float>&, Features, const Synchronisation&, const MeterInput<float>&);
template MeterReading meter(const SubstepParams<double>&, Features, const Synchronisation&, const MeterInput<double>&);

}  // namespace ballpit::cpu
