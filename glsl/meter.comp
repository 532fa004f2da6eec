#version 430 core
// One thread a ball: energies, heats and what else is metered, at the start of a substep, with velocities at the time
// of the positions. A work group adds up its balls in their order, so that the sums are the same in every run.
// Where balls touch each other it runs between collide and the exchange of states and reads both; where they do not,
// before collide, which works in place.
// Laws that the scene does not declare are not compiled in.
#include "shared/dispatch.glsl"
#if defined(LAW_CONTACT) || defined(LAW_WALLS)
#define LAW_SPRING
#endif

layout(local_size_x = GROUP_SIZE) in;

layout(std140, binding = BLOCK_PARAMS) uniform ParamsBlock {
    uint ball_count;
#ifdef LAW_GRAVITY
    vec3 gravity;                // m/s^2
#endif
#ifdef LAW_SPRING
    float stiffness;             // N/m
#ifndef LAW_UNEQUAL_RADII
    float radius;                // m, of every ball
#endif
#ifndef LAW_UNEQUAL_MASSES
    float mass;                  // kg, of every ball
#endif
#endif
#if defined(LAW_DASHPOT) && !defined(LAW_BALL_RESTITUTION)
    float damping_ratio;         // dashpot zeta of every ball
#endif
#ifdef LAW_SEMI_IMPLICIT
    float damping_time;          // s
#endif
    vec3 box_lower;              // m
    vec3 box_upper;
#ifdef LAW_WALLS
    float wall_depth;            // m: deeper in a wall, a ball is pushed no harder
    vec3 lower_velocity;         // m/s, of the lower walls
    vec3 upper_velocity;
#endif
#ifdef LAW_PULL
    vec3 pull_target;            // m
    uint pull_ball;
    float pull_rate;             // 1/s
#endif
#if defined(LAW_CONTACT) && !defined(NEIGHBOURS_BRUTE_FORCE)
    vec3 grid_origin;            // m: lower corner of cell 0
    float inverse_cell_width;    // 1/m
    uvec3 grid_cells;            // cells along x, y, z
#endif
} params;

// A velocity at the time of the positions is x * the old one + y * the new one + z * acceleration (core/meter.h).
uniform vec4 synchronisation;

layout(std430, binding = SLOT_POSITIONS) readonly buffer PositionsBlock { vec4 positions[]; };
layout(std430, binding = SLOT_VELOCITIES) readonly buffer VelocitiesBlock { vec4 velocities[]; };
#ifdef LAW_CONTACT
layout(std430, binding = SLOT_NEXT_VELOCITIES) readonly buffer NextVelocitiesBlock { vec4 next_velocities[]; };
#endif
layout(std430, binding = BINDING_METER_PARTS) writeonly buffer PartsBlock { float parts[]; };

struct Meter {
    float values[METER_VALUES];
    vec3 velocity;               // m/s, of the ball, synchronised
    mat3 stiffness;              // N/m, see add_contact
#ifdef LAW_DASHPOT
    mat3 damping;                // N s/m
#endif
};

#define QUARANTINE
#include "shared/quarantine.glsl"
#define NEIGHBOUR_SUM Meter

// None of the balls any more, or just about to be none.
bool is_out(vec4 position, vec4 velocity) {
    return position.w < 0.0 || !can_be_squared(position.xyz) || !can_be_squared(velocity.xyz);
}

#ifdef LAW_SPRING
#include "shared/contact.glsl"
#endif
#include "shared/contact_ball.glsl"

#ifdef LAW_SPRING
void keep_largest(inout Meter meter, int value, float candidate) {
    meter.values[value] = max(meter.values[value], candidate);
}

// What every contact has. `share`: of it that is this ball's, half of a pair. How stiffly the ball is held, along any
// direction, is at most the sum of 2 k n n^T over its balls and k n n^T over its walls.
void add_contact(inout Meter meter, float overlap, float diameter, float share, vec3 normal) {
    float overlap_share = overlap / diameter;
    meter.values[METER_OVERLAP_SHARES] += share * overlap_share;
    keep_largest(meter, METER_OVERLAP, overlap);
    keep_largest(meter, METER_OVERLAP_SHARE, overlap_share);
    meter.stiffness += outerProduct(normal, (params.stiffness / share) * normal);
}

#ifdef LAW_DASHPOT
void add_dashpot(inout Meter meter, float damping_ratio, float reduced_mass, float share, vec3 normal) {
    float c = dashpot(damping_ratio, reduced_mass);
    meter.damping += outerProduct(normal, (c / share) * normal);
}
#endif
#endif

#ifdef LAW_CONTACT
#include "shared/pair.glsl"

vec3 synchronised(uint id) {
    return synchronisation.x * velocities[id].xyz + synchronisation.y * next_velocities[id].xyz;
}

// Heat is what the force, as collide applied it, takes away beyond what its spring gives back.
void add_pair(Ball a, uint other, inout Meter meter) {
    vec3 normal;
    float overlap;
    float radii;
    if (!touches(a, other, normal, overlap, radii) || is_out(positions[other], velocities[other])) {
        return;
    }
    add_contact(meter, overlap, radii, 0.5, normal);
    meter.values[METER_ELASTIC] += 0.25 * params.stiffness * overlap * overlap;
    meter.values[METER_CONTACT_ENDS] += 1.0;
#ifdef LAW_DASHPOT
    float missing = spring_force(overlap) - pair_force(a, other, normal, overlap);
    meter.values[METER_CONTACT_HEAT] += 0.5 * missing * dot(meter.velocity - synchronised(other), normal);
    float mass = mass_of(velocities[other]);
    add_dashpot(meter, max(a.damping_ratio, damping_ratio_of(other)), a.mass * mass / (a.mass + mass), 0.5, normal);
#endif
}

#ifdef NEIGHBOURS_BRUTE_FORCE
#include "shared/brute_force.glsl"
#else
#include "shared/keys.glsl"
#include "shared/cells.glsl"
#include "shared/neighbours.glsl"
#endif
#endif

#ifdef LAW_WALLS
#include "shared/walls.glsl"

void add_wall(inout Meter meter, Ball ball, float overlap, float force, float speed, float wall_speed, vec3 normal) {
    if (!(overlap > 0.0)) {
        return;
    }
    add_contact(meter, overlap, 2.0 * ball.radius, 1.0, normal);
    float depth = min(overlap, params.wall_depth);
    meter.values[METER_ELASTIC] += params.stiffness * depth * (overlap - 0.5 * depth);
    meter.values[METER_WALL_CONTACTS] += 1.0;
    meter.values[METER_WALL_HEAT] += (spring_force(depth) - force) * (speed - wall_speed);
    meter.values[METER_WALL_WORK] += force * wall_speed;
#ifdef LAW_DASHPOT
    add_dashpot(meter, ball.damping_ratio, ball.mass, 1.0, normal);
#endif
}
#endif

// The largest eigenvalue of a symmetric matrix in closed form (Smith 1961, Communications of the ACM 4, 168).
float largest_eigenvalue(mat3 s) {
    float mean = (s[0][0] + s[1][1] + s[2][2]) / 3.0;
    mat3 rest = s - mat3(mean);
    float p = sqrt((dot(rest[0], rest[0]) + dot(rest[1], rest[1]) + dot(rest[2], rest[2])) / 6.0);
    if (!(p > 0.0)) {
        return mean;
    }
    float r = 0.5 * determinant(rest / p);
    return mean + 2.0 * p * cos(acos(clamp(r, -1.0, 1.0)) / 3.0);
}

Meter metered(uint id) {
    vec4 position = positions[id];
    vec4 velocity = velocities[id];
    Meter meter;
    for (int i = 0; i < METER_VALUES; ++i) {
        meter.values[i] = 0.0;
    }
    if (is_out(position, velocity)) {
        return meter;
    }
    Ball ball = make_ball(id, position, velocity);
    meter.stiffness = mat3(0.0);
#ifdef LAW_DASHPOT
    meter.damping = mat3(0.0);
#endif
    float mass = velocity.w;
    vec3 pull = vec3(0.0);
#ifdef LAW_PULL
    if (id == params.pull_ball) {
        pull = mass * (params.pull_rate * params.pull_rate * (params.pull_target - ball.position) -
                       2.0 * params.pull_rate * ball.velocity);
    }
#endif
#ifdef LAW_WALLS
    precise vec3 low = ball.radius - (ball.position - params.box_lower);   // as add_walls() has it
    precise vec3 high = ball.radius - (params.box_upper - ball.position);
    vec3 low_force;
    vec3 high_force;
    for (int axis = 0; axis < 3; ++axis) {
        low_force[axis] = wall_force(low[axis], ball.velocity[axis] - params.lower_velocity[axis], ball);
        high_force[axis] = wall_force(high[axis], params.upper_velocity[axis] - ball.velocity[axis], ball);
    }
#endif
#ifdef LAW_CONTACT
    meter.velocity = synchronised(id);
    add_neighbours(ball, meter);
#else
    vec3 acceleration = pull / mass;
#ifdef LAW_WALLS
    acceleration += (low_force - high_force) / mass;
#endif
#ifdef LAW_GRAVITY
    acceleration += params.gravity;
#endif
    meter.velocity = synchronisation.x * ball.velocity + synchronisation.z * acceleration;
#endif
#ifdef LAW_WALLS
    for (int axis = 0; axis < 3; ++axis) {
        vec3 normal = vec3(axis == 0, axis == 1, axis == 2);
        add_wall(meter, ball, low[axis], low_force[axis], meter.velocity[axis], params.lower_velocity[axis], normal);
        add_wall(meter, ball, high[axis], high_force[axis], -meter.velocity[axis], -params.upper_velocity[axis],
                 normal);
    }
    meter.values[METER_FLOOR_FORCE] = low_force.z;
#endif
    vec3 momentum = mass * meter.velocity;
    vec3 angular = cross(ball.position - 0.5 * (params.box_lower + params.box_upper), momentum);
    meter.values[METER_KINETIC] = 0.5 * dot(momentum, meter.velocity);
#ifdef LAW_GRAVITY
    meter.values[METER_POTENTIAL] = -mass * dot(params.gravity, ball.position);
#endif
    meter.values[METER_HAND_WORK] = dot(pull, meter.velocity);
    for (int axis = 0; axis < 3; ++axis) {
        meter.values[METER_MOMENTUM + axis] = momentum[axis];
        meter.values[METER_ANGULAR_MOMENTUM + axis] = angular[axis];
    }
    meter.values[METER_MASS] = mass;
    meter.values[METER_SPEED] = length(meter.velocity);
    meter.values[METER_STIFFNESS] = largest_eigenvalue(meter.stiffness) / mass;
#ifdef LAW_DASHPOT
    meter.values[METER_DAMPING] = largest_eigenvalue(meter.damping) / mass;
#endif
    meter.values[METER_SPEED_SHARE] = meter.values[METER_SPEED] / (2.0 * position.w);
    meter.values[METER_LIGHTNESS] = 1.0 / mass;
    return meter;
}

shared float of_balls[METER_VALUES][GROUP_SIZE];

void main() {
#ifdef LAW_CONTACT
    uint id = sliced_index();
#else
    uint id = global_index();
#endif
    uint thread = gl_LocalInvocationIndex;
    if (id < params.ball_count) {
        Meter meter = metered(id);
        for (int i = 0; i < METER_VALUES; ++i) {
            of_balls[i][thread] = meter.values[i];
        }
    } else {
        for (int i = 0; i < METER_VALUES; ++i) {
            of_balls[i][thread] = 0.0;
        }
    }
    memoryBarrierShared();
    barrier();
    uint group = (id - thread) / GROUP_SIZE;
    if (thread < METER_VALUES && id - thread < params.ball_count) {
        float total = 0.0;
        // Eight sums of eight: half as much rounding as one after the other, or less.
        for (int first = 0; first < GROUP_SIZE; first += 8) {
            float part = 0.0;
            for (int i = first; i < first + 8; ++i) {
                part = thread < METER_SUMS ? part + of_balls[thread][i] : max(part, of_balls[thread][i]);
            }
            total = thread < METER_SUMS ? total + part : max(total, part);
        }
        parts[group * METER_VALUES + thread] = total;
    }
}
