#version 430 core
// Equal balls that bounce off each other and off six walls, without loss and without gravity; written by hand.
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
    float stiffness;
    float gain;
    float drift;
} params;

layout(std430, binding = 0) readonly buffer PositionsBlock { vec4 positions[]; };
layout(std430, binding = 1) readonly buffer VelocitiesBlock { vec4 velocities[]; };
layout(std430, binding = 3) readonly buffer KeysBlock { uvec2 keys[]; };              // cell, ball
layout(std430, binding = 4) readonly buffer CellRangesBlock { uvec2 cell_ranges[]; };  // first, end
layout(std430, binding = 6) writeonly buffer NextPositionsBlock { vec4 next_positions[]; };
layout(std430, binding = 7) writeonly buffer NextVelocitiesBlock { vec4 next_velocities[]; };

void add_ball(uint id, uint other, vec3 centre, inout vec3 force) {
    precise float reach = params.radius + params.radius;
    precise float reach_squared = reach * reach;
    precise vec3 d = centre - positions[other].xyz;
    precise float d2 = d.x * d.x + d.y * d.y + d.z * d.z;
    if (d2 < reach_squared && other != id && d2 > 0.0) {
        float separation = sqrt(d2);
        precise float push = params.stiffness * (reach - separation);
        precise vec3 sum = force + push * (d / separation);
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
                    add_ball(id, keys[slot].y, centre, force);
                }
            }
        }
    }
    precise vec3 in_low = params.radius - (centre - params.box_lower);
    precise vec3 in_high = params.radius - (params.box_upper - centre);
    force = force + params.stiffness * max(in_low, 0.0);
    force = force - params.stiffness * max(in_high, 0.0);
    precise vec3 v = velocity.xyz + params.gain * (force / params.mass);
    precise vec3 x = centre + params.drift * v;
    next_positions[id] = vec4(x, position.w);
    next_velocities[id] = vec4(v, velocity.w);
}
