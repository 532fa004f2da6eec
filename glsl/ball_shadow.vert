#version 330 core
// Each ball as the light sees it: a disc through its centre, which holds the cone of light that it catches. The lit
// half of the ball lies before its disc, so that no ball shades itself and no bias is needed.
#include "shared/frame.glsl"
#include "shared/ball.glsl"
#include "shared/fade_ball.glsl"
#include "shared/shadow.glsl"

layout(location = 0) in vec2 corner;     // -1 or 1
layout(location = 3) in vec4 state;      // centre, radius

out vec2 across;

void main() {
    vec4 ball = whole_ball(state);
    vec3 axis = ball.xyz - frame.light_position;
    float away = length(axis);
    vec3 ahead = axis / away;
    float squared = away * away - ball.w * ball.w;
    bool drawn = is_finite(ball) && squared > 0.0 && ahead.z <= shadow_horizon;
#ifdef FADED
    shown = presence_of(ball);
    drawn = drawn && shown > 0.0;
#endif
    if (!drawn) {
        gl_Position = nowhere;
        return;
    }
    vec3 side = normalize(abs(ahead.x) < 0.7 ? vec3(0.0, ahead.z, -ahead.y) : vec3(-ahead.z, 0.0, ahead.x));
    float size = ball.w * away * inversesqrt(squared);
    vec3 place = axis + size * (corner.x * side + corner.y * cross(side, ahead));
    across = corner;
    gl_Position = vec4(shadow_place(normalize(place)), 2.0 * away / frame.shadow_range - 1.0, 1.0);
}
