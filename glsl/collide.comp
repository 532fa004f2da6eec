#version 430 core
// One thread a ball, or with SORTED_COPIES one a slot: contact forces of the balls in 3 x 3 x 3 cells and of the walls,
// gravity, drag, and the integrator. Where balls touch each other the result goes into the other state buffer, so that every thread reads
// only the old state: no race, no order. Where they do not, each thread has its ball to itself and works in place.
// `precise` keeps the compiler from contracting and reordering, so that the mirror can agree bit for bit.
// Laws that the scene does not declare are not compiled in, declarations included.
#include "shared/dispatch.glsl"
#ifdef DIAGNOSTICS
#define QUARANTINE
#include "shared/quarantine.glsl"
#include "shared/status.glsl"
#endif
#if defined(LAW_CONTACT) || defined(LAW_WALLS)
#define LAW_SPRING
#endif

layout(local_size_x = GROUP_SIZE) in;

// A kick turns v into decay * v + gain * a.
layout(std140, binding = BLOCK_PARAMS) uniform ParamsBlock {
    uint ball_count;
    float drift;                 // s: x moves by drift * v
    float gain;                  // s: duration of the kick, shortened by drag
#ifdef INTEGRATOR_VELOCITY_VERLET
    float second_gain;           // s: the same for the second kick
#endif
#ifdef LAW_DRAG
#ifdef LAW_COMPENSATED
    float decay_change;          // decay - 1, which in single would be rounded away
#ifdef INTEGRATOR_VELOCITY_VERLET
    float second_decay_change;
#endif
#else
    float decay;                 // factor of the kick: exp(-drag * duration)
#ifdef INTEGRATOR_VELOCITY_VERLET
    float second_decay;
#endif
#endif
#endif
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
#if defined(LAW_WALLS) || defined(DIAGNOSTICS)
    vec3 box_lower;              // m
#endif
#ifdef LAW_WALLS
    vec3 box_upper;
    float wall_depth;            // m: deeper in a wall, a ball is pushed no harder
#ifdef LAW_MOVING_WALLS
    vec3 lower_velocity;         // m/s, of the lower walls
    vec3 upper_velocity;
#endif
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

#ifdef LAW_CONTACT
layout(std430, binding = SLOT_POSITIONS) readonly buffer PositionsBlock { vec4 positions[]; };
layout(std430, binding = SLOT_VELOCITIES) readonly buffer VelocitiesBlock { vec4 velocities[]; };
layout(std430, binding = SLOT_NEXT_POSITIONS) writeonly buffer NextPositionsBlock { vec4 next_positions[]; };
layout(std430, binding = SLOT_NEXT_VELOCITIES) writeonly buffer NextVelocitiesBlock { vec4 next_velocities[]; };
#else
layout(std430, binding = SLOT_POSITIONS) buffer PositionsBlock { vec4 positions[]; };
layout(std430, binding = SLOT_VELOCITIES) buffer VelocitiesBlock { vec4 velocities[]; };
#endif

#define NEIGHBOUR_SUM vec3       // the force, N
#ifdef LAW_SPRING
#include "shared/contact.glsl"
#endif
#include "shared/contact_ball.glsl"
#ifdef LAW_CONTACT
#ifndef NEIGHBOURS_BRUTE_FORCE
#include "shared/keys.glsl"
#endif
#include "shared/pair.glsl"
#ifdef NEIGHBOURS_BRUTE_FORCE
#include "shared/brute_force.glsl"
#else
#include "shared/cells.glsl"
#include "shared/neighbours.glsl"
#endif
#endif
#ifdef LAW_WALLS
#include "shared/walls.glsl"
#endif
#ifdef LAW_COMPENSATED
#include "shared/compensated.glsl"
#endif

vec3 acceleration(Ball ball) {
    precise vec3 a = vec3(0.0);
#ifdef LAW_SPRING
    precise vec3 force = vec3(0.0);
#ifdef LAW_CONTACT
    add_neighbours(ball, force);
#endif
#ifdef LAW_WALLS
    add_walls(ball, force);
#endif
    a = force / ball.mass;
#endif
#ifdef LAW_GRAVITY
    a = a + params.gravity;
#endif
#ifdef LAW_PULL
    // A critically damped spring to a point, as strong for any mass: the hand that holds a ball.
    if (ball.id == params.pull_ball) {
        a = a + (params.pull_rate * params.pull_rate) * (params.pull_target - ball.position);
        a = a - (2.0 * params.pull_rate) * ball.velocity;
    }
#endif
    return a;
}

// `left_out`: what rounding has left out of v, which only compensated sums look at.
vec3 kick(vec3 v, vec3 a, inout vec3 left_out) {
#if defined(LAW_COMPENSATED) && defined(LAW_DRAG)
    precise vec3 change = params.decay_change * v + params.gain * a;
    return compensated_sum(v, change, left_out);
#elif defined(LAW_COMPENSATED)
    precise vec3 change = params.gain * a;
    return compensated_sum(v, change, left_out);
#elif defined(LAW_DRAG)
    precise vec3 kicked = params.decay * v + params.gain * a;
    return kicked;
#else
    precise vec3 kicked = v + params.gain * a;
    return kicked;
#endif
}

#ifdef INTEGRATOR_VELOCITY_VERLET
vec3 second_kick(vec3 v, vec3 a, inout vec3 left_out) {
#if defined(LAW_COMPENSATED) && defined(LAW_DRAG)
    precise vec3 change = params.second_decay_change * v + params.second_gain * a;
    return compensated_sum(v, change, left_out);
#elif defined(LAW_COMPENSATED)
    precise vec3 change = params.second_gain * a;
    return compensated_sum(v, change, left_out);
#elif defined(LAW_DRAG)
    precise vec3 kicked = params.second_decay * v + params.second_gain * a;
    return kicked;
#else
    precise vec3 kicked = v + params.second_gain * a;
    return kicked;
#endif
}
#endif

// `v`: after the kicks.
vec3 way(Ball ball, vec3 v, vec3 a) {
#if defined(INTEGRATOR_FORWARD_EULER)
    precise vec3 way = params.drift * ball.velocity;
#elif defined(INTEGRATOR_HISTORICAL)
    precise vec3 way = params.drift * ball.velocity + (0.5 * params.drift * params.drift) * a;
#else
    precise vec3 way = params.drift * v;
#endif
    return way;
}

vec3 moved(vec3 x, vec3 way, inout vec3 left_out) {
#ifdef LAW_COMPENSATED
    return compensated_sum(x, way, left_out);
#else
    precise vec3 sum = x + way;
    return sum;
#endif
}

#ifdef DIAGNOSTICS
// Along each axis where the ball was, or else in the box's corner.
vec3 last_place(vec3 x) {
    vec3 place = params.box_lower;
    for (int axis = 0; axis < 3; ++axis) {
        if (can_be_squared(vec3(x[axis]))) {
            place[axis] = x[axis];
        }
    }
    return place;
}

#ifdef LAW_SPRING
void count_speed(vec3 way, float radius) {
    precise float way_squared = way.x * way.x + way.y * way.y + way.z * way.z;
    precise float radius_squared = radius * radius;
    if (way_squared > radius_squared) {
        atomicOr(status.bits, STATUS_TOO_FAST);
        atomicAdd(status.too_fast, 1u);
    }
}
#endif
#endif

void main() {
#ifdef LAW_CONTACT
    uint place = sliced_index();   // of the ball, in `positions` and `velocities`
#else
    uint place = global_index();
#endif
    if (place >= params.ball_count) {
        return;
    }
#ifdef SORTED_COPIES
    uint id = keys[place].ball_id;
#ifndef KEPT_ORDER
    if (id >= params.ball_count) {
        return;   // a key that no sort has put there
    }
#endif
#else
    uint id = place;
#endif
#ifdef KEPT_ORDER
    uint next = place;   // where its next state goes
#else
    uint next = id;
#endif
    vec4 position = positions[place];
    vec4 velocity = velocities[place];
#ifdef QUARANTINE
    if (position.w < 0.0) {
#ifdef LAW_CONTACT
        next_positions[next] = position;
        next_velocities[next] = velocity;
#endif
        return;
    }
#endif
    Ball ball = make_ball(id, position, velocity);
#ifdef SORTED_COPIES
    ball.place = place;
#endif
    vec3 left_of_x = vec3(0.0);
    vec3 left_of_v = vec3(0.0);
#ifdef LAW_COMPENSATED
    Compensation left = compensations[id];
    left_of_x = vec3(left.x, left.y, left.z);
    left_of_v = vec3(left.vx, left.vy, left.vz);
    ball.left_out = left_of_x;
#endif
    vec3 a = acceleration(ball);
    vec3 v = kick(ball.velocity, a, left_of_v);
#ifdef INTEGRATOR_VELOCITY_VERLET
    v = second_kick(v, a, left_of_v);
#endif
    vec3 step = way(ball, v, a);
    vec3 x = moved(ball.position, step, left_of_x);
#ifdef DIAGNOSTICS
    if (!can_be_squared(x) || !can_be_squared(v)) {
        atomicOr(status.bits, STATUS_NOT_FINITE);
        atomicAdd(status.not_finite, 1u);
        atomicMax(status.quarantined_ball, id + 1u);
        x = last_place(ball.position);
        v = vec3(0.0);
        left_of_x = vec3(0.0);
        left_of_v = vec3(0.0);
        position.w = -position.w;
    }
#ifdef LAW_SPRING
    else {
        count_speed(step, position.w);
    }
#endif
#endif
#ifdef LAW_COMPENSATED
    compensations[id] = Compensation(left_of_x.x, left_of_x.y, left_of_x.z, left_of_v.x, left_of_v.y, left_of_v.z);
#endif
#ifdef LAW_CONTACT
    next_positions[next] = vec4(x, position.w);
    next_velocities[next] = vec4(v, velocity.w);
#else
    positions[id] = vec4(x, position.w);
    velocities[id] = vec4(v, velocity.w);
#endif
}
