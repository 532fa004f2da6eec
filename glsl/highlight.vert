#version 330 core
// A square round a highlighted ball, in the plane through its centre that faces the eye.
#include "shared/frame.glsl"
#include "shared/ball.glsl"

layout(location = 0) in uint id;
layout(location = 1) in vec4 ring_colour;

uniform samplerBuffer elements;          // centre, radius of every ball

out vec2 across;                         // 1 from the middle: the ball's outline
flat out float ring;                     // width of the ring, in the same measure
flat out vec4 paint;

const float halo = 2.5;                  // ring widths
const float smallest = 4.0;              // pixels: radius of the outline of balls that are hardly seen
const float thinnest = 2.0;              // pixels

void main() {
    vec4 ball = whole_ball(texelFetch(elements, int(id)));
    vec3 axis = ball.xyz - frame.eye;
    float squared = dot(axis, axis) - ball.w * ball.w;
    if (!is_finite(ball) || squared <= 0.0) {
        gl_Position = nowhere;
        return;
    }
    float away = length(axis);
    float pixel = pixel_at(away);
    float outline = max(ball.w * away * inversesqrt(squared), smallest * pixel);
    ring = max(0.12, thinnest * pixel / outline);
    vec2 corner = vec2((gl_VertexID & 1) != 0 ? 1.0 : -1.0, (gl_VertexID & 2) != 0 ? 1.0 : -1.0);
    across = corner * (1.0 + halo * ring);
    paint = ring_colour;
    vec3 ahead = axis / away;
    vec3 side = normalize(frame.camera_right - dot(frame.camera_right, ahead) * ahead);
    vec3 place = ball.xyz + outline * (across.x * side + across.y * cross(side, ahead));
    gl_Position = frame.view_projection * vec4(place, 1.0);
}
