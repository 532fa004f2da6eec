#version 330 core
// Only depth is kept.
in vec2 across;

#ifdef FADED
flat in float shown;

// A share of the pixels: the soft edge's comparisons make a lighter shadow of them. Thresholds of a 4 x 4 matrix
// (Bayer 1973), from the bits of x XOR y and of y, the lowest first.
bool in_share() {
    ivec2 at = ivec2(gl_FragCoord.xy) & 3;
    int mixed = at.x ^ at.y;
    int rank = ((mixed & 1) << 3) | ((at.y & 1) << 2) | (mixed & 2) | (at.y >> 1);
    return shown > (float(rank) + 0.5) / 16.0;
}
#else
bool in_share() { return true; }
#endif

void main() {
    if (dot(across, across) > 1.0 || !in_share()) {
        discard;
    }
}
