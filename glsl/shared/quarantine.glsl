// A ball whose position or velocity is no number, or too large to be squared, goes into quarantine: it stays where it
// was last, at rest, and touches nobody. Its radius is negative from then on.

// Energies and distances are squares: what is beyond them is as good as infinite. False for NaN, too: by bits, because a
// compiler may assume that nothing is NaN.
bool can_be_squared(vec3 v) {
    precise float size = v.x * v.x + v.y * v.y + v.z * v.z;
    return (floatBitsToUint(size) & 0x7F800000u) != 0x7F800000u;
}
