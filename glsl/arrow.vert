#version 330 core
// A flat arrow that faces the eye, from a ball's surface along its velocity: a shaft of two triangles and a head.
#include "shared/frame.glsl"
#include "shared/ball.glsl"
#include "shared/fade_ball.glsl"

layout(location = 3) in vec4 ball;       // centre, radius
layout(location = 4) in vec4 velocity;   // velocity, mass

out vec2 edge;                           // x / y: -1 to 1 from one side of the arrow to the other
flat out vec3 paint;

const float shortest = 3.0;              // pixels: shorter ones tell nothing
const float thinnest = 0.9;              // pixels, of half the shaft

void main() {
    float speed = length(velocity.xyz);
    float size = speed * frame.arrow_seconds;
    float pixel = pixel_at(distance(ball.xyz, frame.eye));
    bool drawn = is_finite(ball) && is_finite(velocity) && size > shortest * pixel;
#ifdef FADED
    shown = presence_of(ball);
    drawn = drawn && shown > 0.0;
#endif
    if (!drawn) {
        gl_Position = nowhere;
        return;
    }
    vec3 ahead = velocity.xyz / speed;
    vec3 start = ball.xyz + ball.w * ahead;
    vec3 side = cross(ahead, start - frame.eye);
    side = dot(side, side) > 0.0 ? normalize(side) : frame.camera_right;
    float half_shaft = max(0.16 * ball.w, thinnest * pixel);
    float head = min(3.6 * half_shaft, 0.6 * size);
    bool in_head = gl_VertexID >= 6;
    int corner = in_head ? gl_VertexID - 6 : gl_VertexID < 3 ? gl_VertexID : gl_VertexID - 2;   // 0 1 2, 1 2 3
    float flank = (corner & 1) != 0 ? 1.0 : -1.0;
    bool at_front = corner >= 2;
    float along = in_head ? (at_front ? size : size - head) : (at_front ? size - head : 0.0);
    float wide = in_head ? (at_front ? 0.0 : 2.6 * half_shaft) : half_shaft;
    edge = in_head && at_front ? vec2(0.0) : vec2(flank, 1.0);
    paint = sequential_colour(speed / frame.top_speed);
    gl_Position = frame.view_projection * vec4(start + along * ahead + flank * wide * side, 1.0);
}
