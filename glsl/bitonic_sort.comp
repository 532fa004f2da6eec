#version 430 core
// One pass of the bitonic network: one thread a pair of slots (lower, lower XOR j).
// The pairs are disjoint, so sorting in place is no race.
#include "shared/dispatch.glsl"
#include "shared/keys.glsl"

layout(local_size_x = GROUP_SIZE) in;

layout(std140, binding = BLOCK_PARAMS) uniform ParamsBlock { uint key_count; } params;

void main() {
    uint pair = global_index();
    if (pair >= params.key_count / 2u) {
        return;
    }
    uint k = dispatch_constants.x;
    uint j = dispatch_constants.y;
    // Insert a 0 at bit j: the slots whose bit j is 0 are the lower ones.
    uint lower = ((pair & ~(j - 1u)) << 1) | (pair & (j - 1u));
    uint upper = lower | j;
    bool ascending = (lower & k) == 0u;
    Key a = keys[lower];
    Key b = keys[upper];
    if (key_less(b, a) == ascending) {
        keys[lower] = b;
        keys[upper] = a;
    }
}
