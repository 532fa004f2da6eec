// A line as a strip of four vertices, of constant width in pixels. Needs shared/frame.glsl.

// Cut at the near plane first: behind the eye a direction on the screen means nothing. False where nothing is left.
bool cut_at_near_plane(inout vec4 from, inout vec4 to) {
    float from_near = from.z + from.w;
    float to_near = to.z + to.w;
    if (from_near <= 0.0 && to_near <= 0.0) {
        return false;
    }
    if (from_near < 0.0) {
        from = mix(from, to, from_near / (from_near - to_near));
    } else if (to_near < 0.0) {
        to = mix(to, from, to_near / (to_near - from_near));
    }
    return true;
}

// The vertex, `half_width` pixels beside the line and beyond its end. `place`: pixels along the line and beside it;
// `size`: its length in pixels.
vec4 wide_line(vec4 from, vec4 to, float half_width, out vec2 place, out float size) {
    vec2 along = 0.5 * frame.picture_size * (to.xy / to.w - from.xy / from.w);
    size = length(along);
    vec2 ahead = size > 0.0 ? along / size : vec2(1.0, 0.0);
    bool at_end = (gl_VertexID & 2) != 0;
    vec4 vertex = at_end ? to : from;
    float beyond = at_end ? half_width : -half_width;
    float beside = (gl_VertexID & 1) != 0 ? half_width : -half_width;
    place = vec2(at_end ? size + beyond : beyond, beside);
    vertex.xy += 2.0 * (beyond * ahead + beside * vec2(-ahead.y, ahead.x)) / frame.picture_size * vertex.w;
    return vertex;
}
