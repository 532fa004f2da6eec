#version 430 core
// Equal balls under gravity, with a dashpot in every contact that may push but not pull; written by hand.
layout(local_size_x = 64) in;

layout(std140, binding = 0) uniform ParamsBlock {
    vec3 grid_origin;
    float inverse_cell_width;
    uvec3 grid_cells;
    uint ball_count;
    vec3 box_lower;
    float radius;
    vec3 box_upper;
    float mass;
    vec3 gravity;
    float stiffness;
    float damping_ratio;
    float gain;
    float drift;
} params;

layout(std430, binding = 0) readonly buffer PositionsBlock { vec4 positions[]; };
layout(std430, binding = 1) readonly buffer VelocitiesBlock { vec4 velocities[]; };
layout(std430, binding = 3) readonly buffer KeysBlock { uvec2 keys[]; };              // cell, ball
layout(std430, binding = 4) readonly buffer CellRangesBlock { uvec2 cell_ranges[]; };  // first, end
layout(std430, binding = 6) writeonly buffer NextPositionsBlock { vec4 next_positions[]; };
layout(std430, binding = 7) writeonly buffer NextVelocitiesBlock { vec4 next_velocities[]; };

float dashpot(float reduced_mass) {
    precise float c = 2.0 * params.damping_ratio * sqrt(params.stiffness * reduced_mass);
    return c;
}

float push(float overlap, float speed, float c) {
    precise float force = params.stiffness * overlap - c * speed;
    return max(force, 0.0);
}

void add_ball(uint id, uint other, vec3 centre, vec3 velocity, inout vec3 force) {
    precise float reach = params.radius + params.radius;
    precise float reach_squared = reach * reach;
    precise vec3 d = centre - positions[other].xyz;
    precise float d2 = d.x * d.x + d.y * d.y + d.z * d.z;
    if (d2 < reach_squared && other != id && d2 > 0.0) {
        float separation = sqrt(d2);
        precise vec3 normal = d / separation;
        precise vec3 u = velocity - velocities[other].xyz;
        precise float speed = u.x * normal.x + u.y * normal.y + u.z * normal.z;
        precise float reduced_mass = params.mass * params.mass / (params.mass + params.mass);
        precise float overlap = reach - separation;
        precise vec3 sum = force + push(overlap, speed, dashpot(reduced_mass)) * normal;
        force = sum;
    }
}

void main() {
    uint id = gl_GlobalInvocationID.x;
    if (id >= params.ball_count) {
        return;
    }
    vec4 position = positions[id];
    vec4 velocity = velocities[id];
    vec3 centre = position.xyz;
    precise vec3 force = vec3(0.0);
    precise vec3 scaled = (centre - params.grid_origin) * params.inverse_cell_width;
    uvec3 last = params.grid_cells - 1u;
    uvec3 cell = uvec3(clamp(floor(scaled), vec3(0.0), vec3(last)));
    uvec3 low = cell - min(cell, uvec3(1u));
    uvec3 high = min(cell + 1u, last);
    for (uint z = low.z; z <= high.z; ++z) {
        for (uint y = low.y; y <= high.y; ++y) {
            for (uint x = low.x; x <= high.x; ++x) {
                uvec2 range = cell_ranges[(z * params.grid_cells.y + y) * params.grid_cells.x + x];
                for (uint slot = range.x; slot < range.y; ++slot) {
                    add_ball(id, keys[slot].y, centre, velocity.xyz, force);
                }
            }
        }
    }
    precise vec3 in_low = params.radius - (centre - params.box_lower);
    precise vec3 in_high = params.radius - (params.box_upper - centre);
    for (int axis = 0; axis < 3; ++axis) {
        if (in_low[axis] > 0.0) {
            force[axis] = force[axis] + push(in_low[axis], velocity[axis], dashpot(params.mass));
        }
        if (in_high[axis] > 0.0) {
            force[axis] = force[axis] - push(in_high[axis], -velocity[axis], dashpot(params.mass));
        }
    }
    precise vec3 v = velocity.xyz + params.gain * (force / params.mass + params.gravity);
    precise vec3 x = centre + params.drift * v;
    next_positions[id] = vec4(x, position.w);
    next_velocities[id] = vec4(v, velocity.w);
}
