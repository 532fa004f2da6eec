#version 330 core
// The twelve edges of the box, each a strip of constant width in pixels.
#include "shared/frame.glsl"

out float across;                        // -1 to 1

const float half_width = 1.5;            // pixels

vec3 corner_of_edge(int edge, float end) {
    int axis = edge / 4;
    vec3 side = vec3((edge & 1) != 0 ? 1.0 : -1.0, (edge & 2) != 0 ? 1.0 : -1.0, end);
    return frame.half_extent * (axis == 0 ? side.zxy : axis == 1 ? side.xzy : side.xyz);
}

void main() {
    vec4 from = frame.view_projection * vec4(corner_of_edge(gl_InstanceID, -1.0), 1.0);
    vec4 to = frame.view_projection * vec4(corner_of_edge(gl_InstanceID, 1.0), 1.0);
    // Cut at the near plane first: behind the eye a direction on the screen means nothing.
    float from_near = from.z + from.w;
    float to_near = to.z + to.w;
    if (from_near <= 0.0 && to_near <= 0.0) {
        gl_Position = nowhere;
        return;
    }
    if (from_near < 0.0) {
        from = mix(from, to, from_near / (from_near - to_near));
    } else if (to_near < 0.0) {
        to = mix(to, from, to_near / (to_near - from_near));
    }
    vec2 along = (to.xy / to.w - from.xy / from.w) * frame.picture_size;
    vec2 normal = length(along) > 0.0 ? normalize(vec2(-along.y, along.x)) : vec2(0.0);
    vec4 place = (gl_VertexID & 2) != 0 ? to : from;
    across = (gl_VertexID & 1) != 0 ? 1.0 : -1.0;
    place.xy += across * 2.0 * half_width * normal / frame.picture_size * place.w;
    gl_Position = place;
}
