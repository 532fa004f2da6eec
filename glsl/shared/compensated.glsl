// Sums that keep what rounding leaves out of them (Kahan), so that many small increments add up to what they are.

layout(std430, binding = SLOT_COMPENSATIONS) buffer CompensationsBlock { Compensation compensations[]; };

// Adds the increment and what earlier sums have left out; leaves out what this one does. The rest of a rounded sum is
// Knuth's, exact whichever of the two is larger: a ball comes to rest, and it passes through 0.
vec3 compensated_sum(vec3 sum, vec3 increment, inout vec3 left_out) {
    precise vec3 added = increment + left_out;
    precise vec3 rounded = sum + added;
    precise vec3 moved = rounded - sum;
    precise vec3 rest = (sum - (rounded - moved)) + (added - moved);
    left_out = rest;
    return rounded;
}
