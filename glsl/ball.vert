#version 330 core
// One instance of the model a ball, straight from the physics' buffers.
#include "shared/frame.glsl"
#include "shared/ball.glsl"

layout(location = 0) in vec3 vertex;
layout(location = 1) in vec3 vertex_normal;
layout(location = 2) in vec2 vertex_uv;
layout(location = 3) in vec4 ball;       // centre, radius
layout(location = 4) in vec4 velocity;   // velocity, mass

out vec3 place;
out vec3 normal;
out vec2 uv;
flat out vec4 tint;

void main() {
    uint id = uint(gl_InstanceID);
    vec4 turn = ball_turn(id);
    place = ball.xyz + ball.w * turned(turn, vertex);
    normal = turned(turn, vertex_normal);
    uv = vertex_uv;
    tint = ball_tint(id, ball.xyz, velocity.xyz);
    gl_Position = is_finite(ball) ? frame.view_projection * vec4(place, 1.0) : nowhere;
}
