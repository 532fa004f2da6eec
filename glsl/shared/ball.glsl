// What the ball shaders share: which balls can be drawn, how each is turned, and its colour. Needs shared/frame.glsl.

// By bits, because a compiler may assume that nothing is NaN.
bool is_finite(vec4 v) {
    uvec4 exponent = floatBitsToUint(v) & uvec4(0x7F800000u);
    return all(notEqual(exponent, uvec4(0x7F800000u)));
}

// The radius of a ball in quarantine is negative (shared/quarantine.glsl).
vec4 whole_ball(vec4 state) { return vec4(state.xyz, abs(state.w)); }

const vec4 quarantine_tint = vec4(1.0, 0.02, 0.02, 1.0);

uint scrambled(uint x) {
    x = (x ^ (x >> 16)) * 0x7FEB352Du;
    x = (x ^ (x >> 15)) * 0x846CA68Bu;
    return x ^ (x >> 16);
}

// A turn (quaternion) of each ball's own, always the same: balls do not spin, but should not all look alike.
vec4 ball_turn(uint ball) {
    uint bits = scrambled(ball + 1u);
    vec4 q = vec4(uvec4(bits, bits >> 8, bits >> 16, bits >> 24) & 255u) - 127.5;
    return normalize(q);
}

vec3 turned(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }

// Heights of its texture a pixel, at the middle of a ball this far away, where the texture is laid around the sphere.
float texels_a_pixel(float radius, float away) { return away / (3.14159265 * radius * frame.pixels_per_radian); }

// Colour for ball_surface.glsl; w: 1 where it tells a quantity, 0 for a hint that tells neighbours apart.
vec4 ball_tint(uint ball, vec3 centre, vec3 velocity) {
    if (frame.ball_colour == COLOUR_SPEED) {
        return vec4(sequential_colour(length(velocity) / frame.top_speed), 1.0);
    }
    if (frame.ball_colour == COLOUR_CELL) {
        vec3 cell = floor((centre - frame.grid_origin) / frame.cell_width);
        cell = clamp(cell, vec3(0.0), vec3(frame.grid_cells) - 1.0);
        uint id = (uint(cell.z) * frame.grid_cells.y + uint(cell.y)) * frame.grid_cells.x + uint(cell.x);
        return vec4(frame.categorical[scrambled(id) % uint(CATEGORICAL_COLOURS)].rgb, 1.0);
    }
    if (frame.ball_colour == COLOUR_TINTED) {
        return vec4(frame.categorical[ball % uint(CATEGORICAL_COLOURS)].rgb, 0.0);
    }
    return vec4(1.0, 1.0, 1.0, 0.0);
}
