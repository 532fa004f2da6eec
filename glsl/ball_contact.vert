#version 330 core
// A soft dark disc on the ground below each ball near it: less light from everywhere gets there.
#include "shared/frame.glsl"
#include "shared/ball.glsl"
#include "shared/fade_ball.glsl"

layout(location = 0) in vec2 corner;     // -1 or 1
layout(location = 3) in vec4 state;      // centre, radius

out vec2 across;
flat out float strength;

const float reach = 3.0;                 // radii above the ground from where a ball darkens nothing

void main() {
    vec4 ball = whole_ball(state);
    float height = (ball.z - ball.w - frame.box_lower.z) / ball.w;
    float fade = min(1.0 - height / reach, 1.0);
    if (!is_finite(ball) || !(fade > 0.0)) {
        gl_Position = nowhere;
        return;
    }
    across = corner;
    strength = 0.6 * fade;
#ifdef FADED
    shown = presence_of(ball);
    strength *= shown;
#endif
    vec2 place = ball.xy + (1.35 + 0.4 * height) * ball.w * corner;
    gl_Position = frame.view_projection * vec4(place, frame.box_lower.z, 1.0);
}
