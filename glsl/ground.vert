#version 330 core
// The floor of the box and its surroundings, seen from above only.
#include "shared/frame.glsl"

out vec3 place;

void main() {
    vec2 corner = vec2((gl_VertexID & 1) != 0 ? 1.0 : 0.0, (gl_VertexID & 2) != 0 ? 1.0 : 0.0);
    vec2 lower = frame.box_lower.xy - frame.ground_reach;
    vec2 upper = frame.box_upper.xy + frame.ground_reach;
    place = vec3(mix(lower, upper, corner), frame.box_lower.z);
    gl_Position = frame.view_projection * vec4(place, 1.0);
}
