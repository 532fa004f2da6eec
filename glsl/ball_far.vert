#version 330 core
// One point a ball, where every ball is only a few pixels wide.
#include "shared/frame.glsl"
#include "shared/ball.glsl"
#include "shared/ball_value.glsl"

layout(location = 3) in vec4 state;      // centre, radius
layout(location = 4) in vec4 velocity;   // velocity, mass

flat out vec4 sphere;
flat out vec4 tint;
flat out float covers;                   // 1: so small that the whole point is the ball

const float disc_of_square = 1.1283792;  // a square of side 1 is as large as a disc of this diameter

void main() {
    vec4 ball = whole_ball(state);
    uint id = uint(gl_VertexID);
    float across = 2.0 * ball.w * frame.pixels_per_radian / distance(ball.xyz, frame.eye);
    covers = across < 2.5 ? 1.0 : 0.0;
    float size = covers == 1.0 ? across / disc_of_square : across;
    // A point has a whole pixel at least: of balls below that as many are drawn as fill the pixels that they have.
    float share = float(scrambled(id) & 0xFFFFu) / 65536.0;
    if (!is_finite(ball) || share >= size * size) {
        gl_Position = nowhere;
        return;
    }
    gl_Position = frame.view_projection * vec4(ball.xyz, 1.0);
    gl_PointSize = max(size, 1.0);
    sphere = ball;
#ifdef VALUED
    tint = vec4(value_colour(value), 1.0);
#else
    tint = ball_tint(id, ball.xyz, velocity.xyz);
#endif
    if (state.w < 0.0) {
        tint = quarantine_tint;
    }
}
