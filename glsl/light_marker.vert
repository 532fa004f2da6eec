#version 330 core
// A small glowing disc where the light is.
#include "shared/frame.glsl"

out vec2 across;

void main() {
    across = vec2((gl_VertexID & 1) != 0 ? 1.0 : -1.0, (gl_VertexID & 2) != 0 ? 1.0 : -1.0);
    vec3 place = frame.light_position +
                 frame.marker_radius * (across.x * frame.camera_right + across.y * frame.camera_up);
    gl_Position = frame.view_projection * vec4(place, 1.0);
}
