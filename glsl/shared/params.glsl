// The constants of a substep, and the index of this thread.
#include "shared/layout.h"

layout(std140, binding = BLOCK_PARAMS) uniform ParamsBlock { SubstepParams params; };

// Constants of this dispatch alone, such as k and j of a sort pass.
uniform uvec4 dispatch_constants;

// Beyond 65535 groups a dispatch is folded into two dimensions: rows of groups, one after the other.
uint global_index() {
    return gl_GlobalInvocationID.y * gl_NumWorkGroups.x * GROUP_SIZE + gl_GlobalInvocationID.x;
}
