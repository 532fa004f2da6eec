#version 330 core
// One instance of the model a ball, straight from the physics' buffers.
#include "shared/frame.glsl"
#include "shared/ball.glsl"
#include "shared/ball_number.glsl"
#include "shared/ball_value.glsl"
#include "shared/fade_ball.glsl"

#ifdef FADED
uniform bool ghosts;                     // see-through balls, or all others
#endif

layout(location = 0) in vec3 vertex;
layout(location = 1) in vec3 vertex_normal;
layout(location = 2) in vec2 vertex_uv;
layout(location = 3) in vec4 state;      // centre, radius
layout(location = 4) in vec4 velocity;   // velocity, mass

out vec3 place;
out vec3 normal;
out vec2 uv;
flat out vec4 tint;

void main() {
    vec4 ball = whole_ball(state);
    uint id = ball_number();
    vec4 turn = ball_turn(id);
    place = ball.xyz + ball.w * turned(turn, vertex);
    normal = turned(turn, vertex_normal);
    uv = vertex_uv;
#ifdef VALUED
    tint = vec4(value_colour(value), 1.0);
#else
    tint = ball_tint(id, ball.xyz, velocity.xyz);
#endif
    if (state.w < 0.0) {
        tint = quarantine_tint;
    }
    bool drawn = is_finite(ball);
#ifdef FADED
    shown = presence_of(ball);
    drawn = drawn && (ghosts ? shown > 0.0 && shown < 1.0 : shown >= 1.0);
#endif
    gl_Position = drawn ? frame.view_projection * vec4(place, 1.0) : nowhere;
}
