#version 330 core
// A soft dark disc on the ground for each ball near it, away from the light.
#include "shared/frame.glsl"
#include "shared/ball.glsl"

layout(location = 0) in vec2 corner;     // -1 or 1
layout(location = 3) in vec4 ball;       // centre, radius

out vec2 across;
flat out float strength;

const float reach = 4.0;                 // radii above the ground from where a ball darkens nothing

void main() {
    float height = ball.z - ball.w + frame.half_extent.z;
    float fade = 1.0 - height / (reach * ball.w);
    vec3 from_light = ball.xyz - frame.light_position;
    if (!is_finite(ball) || fade <= 0.0 || from_light.z >= 0.0) {
        gl_Position = nowhere;
        return;
    }
    vec2 slide = from_light.xy / -from_light.z;
    slide *= min(1.0, 2.0 / max(length(slide), 1e-6)) * max(height + ball.w, 0.0);
    across = corner;
    strength = 0.75 * min(fade, 1.0);
    vec2 middle = ball.xy + slide;
    float size = ball.w * (1.35 + 0.4 * height / ball.w);
    gl_Position = frame.view_projection * vec4(middle + size * corner, -frame.half_extent.z, 1.0);
}
