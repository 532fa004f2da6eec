// What this dispatch is told, and the index of this thread.
#include "shared/layout.h"

// Constants of this dispatch alone, such as k and j of a sort pass.
uniform uvec4 dispatch_constants;

// Beyond 65535 groups a dispatch is folded into two dimensions: rows of groups, one after the other.
uint global_index() {
    return gl_GlobalInvocationID.y * gl_NumWorkGroups.x * GROUP_SIZE + gl_GlobalInvocationID.x;
}
