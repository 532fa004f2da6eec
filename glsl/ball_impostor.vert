#version 330 core
// One square a ball. It stands in the plane through the centre that faces the eye, just large enough to hold the
// cone of all rays from the eye that touch the sphere.
#include "shared/frame.glsl"
#include "shared/ball.glsl"
#include "shared/ball_number.glsl"
#include "shared/ball_value.glsl"
#include "shared/fade_ball.glsl"

#ifdef FADED
uniform bool ghosts;                     // see-through balls, or all others
#endif

layout(location = 0) in vec2 corner;     // -1 or 1
layout(location = 3) in vec4 state;      // centre, radius
layout(location = 4) in vec4 velocity;   // velocity, mass

out vec3 ray;                            // from the eye to the square
flat out vec4 sphere;
flat out vec4 tint;
flat out vec4 turn;
flat out float texel_scale;              // texture heights a pixel, at the ball's middle

void main() {
    vec4 ball = whole_ball(state);
    vec3 axis = ball.xyz - frame.eye;
    float squared = dot(axis, axis) - ball.w * ball.w;
    bool drawn = is_finite(ball) && squared > 0.0;   // no silhouette from within
#ifdef FADED
    shown = presence_of(ball);
    drawn = drawn && (ghosts ? shown > 0.0 && shown < 1.0 : shown >= 1.0);
#endif
    if (!drawn) {
        gl_Position = nowhere;
        return;
    }
    float size = ball.w * length(axis) * inversesqrt(squared);
    vec3 ahead = normalize(axis);
    vec3 side = normalize(frame.camera_right - dot(frame.camera_right, ahead) * ahead);
    vec3 place = ball.xyz + size * (corner.x * side + corner.y * cross(side, ahead));
    uint id = ball_number();
    ray = place - frame.eye;
    sphere = ball;
#ifdef VALUED
    tint = vec4(value_colour(value), 1.0);
#else
    tint = ball_tint(id, ball.xyz, velocity.xyz);
#endif
    if (state.w < 0.0) {
        tint = quarantine_tint;
    }
    turn = ball_turn(id);
    texel_scale = texels_a_pixel(ball.w, length(axis));
    gl_Position = frame.view_projection * vec4(place, 1.0);
}
