#version 330 core
// The twelve edges of the box, each a strip of constant width in pixels.
#include "shared/frame.glsl"
#include "shared/wide_line.glsl"

out float across;                        // -1 to 1

const float half_width = 1.5;            // pixels

vec3 corner_of_edge(int edge, float end) {
    int axis = edge / 4;
    vec3 side = vec3((edge & 1) != 0 ? 1.0 : 0.0, (edge & 2) != 0 ? 1.0 : 0.0, end);
    return mix(frame.box_lower, frame.box_upper, axis == 0 ? side.zxy : axis == 1 ? side.xzy : side.xyz);
}

void main() {
    vec4 from = frame.view_projection * vec4(corner_of_edge(gl_InstanceID, 0.0), 1.0);
    vec4 to = frame.view_projection * vec4(corner_of_edge(gl_InstanceID, 1.0), 1.0);
    if (!cut_at_near_plane(from, to)) {
        gl_Position = nowhere;
        return;
    }
    vec2 place;
    float size;
    gl_Position = wide_line(from, to, half_width, place, size);
    across = place.y / half_width;
}
