#version 330 core
// Lines of the overlay, one instance each; TETHER: one from the middle of a ball to a point.
#include "shared/frame.glsl"
#include "shared/wide_line.glsl"

#ifdef TETHER
uniform samplerBuffer elements;          // centre, radius of every ball
uniform uint ball_id;
uniform vec3 target;
uniform vec4 tether_colour;
#else
layout(location = 0) in vec3 start;
layout(location = 1) in vec3 end;
layout(location = 2) in vec4 line_colour;
layout(location = 3) in float width;     // pixels
layout(location = 4) in float hidden;    // share of the opacity where balls lie before it
layout(location = 5) in float lift;      // m nearer to the eye, for its depth only
#endif

uniform bool through;                    // draws what shows through balls

noperspective out vec2 place;            // pixels along the line and beside it
flat out float size;                     // its length in pixels
flat out float half_width;
flat out vec4 paint;

const float rim = 1.5;                   // pixels, dark

float lifted_depth(vec3 point, vec4 clip, float lift) {
    vec3 to_eye = frame.eye - point;
    vec4 lifted = frame.view_projection * vec4(point + lift * normalize(to_eye), 1.0);
    bool before_near_plane = lift >= length(to_eye) || lifted.z < -lifted.w;
    return before_near_plane ? -clip.w : lifted.z / lifted.w * clip.w;
}

void main() {
#ifdef TETHER
    vec3 start = texelFetch(elements, int(ball_id)).xyz;
    vec3 end = target;
    vec4 line_colour = tether_colour;
    float width = 3.0;
    float hidden = 0.5;
    float lift = 0.0;
#endif
    vec4 from = frame.view_projection * vec4(start, 1.0);
    vec4 to = frame.view_projection * vec4(end, 1.0);
    half_width = 0.5 * width;
    paint = vec4(line_colour.rgb, line_colour.a * (through ? hidden : 1.0));
    bool whole = from.z + from.w > 0.0 && to.z + to.w > 0.0;
    if (paint.a <= 0.0 || (!whole && !cut_at_near_plane(from, to))) {
        gl_Position = nowhere;
        return;
    }
    if (lift > 0.0 && whole) {
        from.z = lifted_depth(start, from, lift);
        to.z = lifted_depth(end, to, lift);
    }
    gl_Position = wide_line(from, to, half_width + rim, place, size);
}
