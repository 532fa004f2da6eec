#version 330 core
// The floor of the box and its surroundings, seen from above only.
#include "shared/frame.glsl"

out vec3 place;

const float margin = 1.0;                // of the box, around it

void main() {
    vec2 corner = vec2((gl_VertexID & 1) != 0 ? 1.0 : -1.0, (gl_VertexID & 2) != 0 ? 1.0 : -1.0);
    float around = margin * max(frame.half_extent.x, frame.half_extent.y);
    place = vec3(corner * (frame.half_extent.xy + around), -frame.half_extent.z);
    gl_Position = frame.view_projection * vec4(place, 1.0);
}
