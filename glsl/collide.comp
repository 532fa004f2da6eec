#version 430 core
// One thread a ball: contact forces of the balls in 3 x 3 x 3 cells and of the walls, gravity, drag, and the
// integrator, into the other state buffer. Every thread reads only the old state: no race, no order.
// `precise` keeps the compiler from contracting and reordering, so that the mirror can agree bit for bit.
// Laws that the scene does not declare are not compiled in, declarations included.
#include "shared/params.glsl"
#include "shared/status.glsl"

layout(local_size_x = GROUP_SIZE) in;

layout(std430, binding = SLOT_POSITIONS) readonly buffer PositionsBlock { vec4 positions[]; };
layout(std430, binding = SLOT_VELOCITIES) readonly buffer VelocitiesBlock { vec4 velocities[]; };
layout(std430, binding = SLOT_NEXT_POSITIONS) writeonly buffer NextPositionsBlock { vec4 next_positions[]; };
layout(std430, binding = SLOT_NEXT_VELOCITIES) writeonly buffer NextVelocitiesBlock { vec4 next_velocities[]; };

struct Ball {
    uint id;
    vec3 position;
    float radius;
    vec3 velocity;
    float mass;
    float damping_ratio;
};

#include "shared/contact.glsl"
#ifdef LAW_CONTACT
#include "shared/pair.glsl"
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
#endif

vec3 acceleration(Ball ball) {
    precise vec3 force = vec3(0.0);
#ifdef LAW_CONTACT
    add_neighbours(ball, force);
#endif
#ifdef LAW_WALLS
    add_walls(ball, force);
#endif
    precise vec3 a = force / ball.mass;
#ifdef LAW_GRAVITY
    a = a + params.gravity;
#endif
    return a;
}

vec3 kick(vec3 v, vec3 a, float decay, float gain) {
#ifdef LAW_DRAG
    precise vec3 kicked = decay * v + gain * a;
#else
    precise vec3 kicked = v + gain * a;
#endif
    return kicked;
}

bool is_finite(vec3 v) { return !any(isnan(v)) && !any(isinf(v)); }

void main() {
    uint id = global_index();
    if (id >= params.ball_count) {
        return;
    }
    Ball ball = load_ball(id);
    vec3 a = acceleration(ball);
    vec3 v = kick(ball.velocity, a, params.decay, params.gain);
#ifdef INTEGRATOR_VELOCITY_VERLET
    v = kick(v, a, params.second_decay, params.second_gain);
#endif
#if defined(INTEGRATOR_FORWARD_EULER)
    precise vec3 x = ball.position + params.drift * ball.velocity;
#elif defined(INTEGRATOR_HISTORICAL)
    precise vec3 x = ball.position + (params.drift * ball.velocity + (0.5 * params.drift * params.drift) * a);
#else
    precise vec3 x = ball.position + params.drift * v;
#endif
    if (!is_finite(x) || !is_finite(v)) {
        atomicOr(status.bits, STATUS_NOT_FINITE);
        atomicAdd(status.not_finite, 1u);
    }
    next_positions[id] = vec4(x, ball.radius);
    next_velocities[id] = vec4(v, ball.mass);
}
