#version 430 core
// Free fall and nothing else, written by hand: what the permutation of glsl/collide.comp has to be as fast as.
layout(local_size_x = 64) in;

layout(std140, binding = 0) uniform ParamsBlock {
    vec3 gravity;
    float gain;
    float drift;
    uint ball_count;
} params;

layout(std430, binding = 0) buffer PositionsBlock { vec4 positions[]; };
layout(std430, binding = 1) buffer VelocitiesBlock { vec4 velocities[]; };

void main() {
    uint id = gl_GlobalInvocationID.x;
    if (id < params.ball_count) {
        vec4 velocity = velocities[id];
        vec4 position = positions[id];
        precise vec3 v = velocity.xyz + params.gain * params.gravity;
        precise vec3 x = position.xyz + params.drift * v;
        velocities[id] = vec4(v, velocity.w);
        positions[id] = vec4(x, position.w);
    }
}
