// What this dispatch is told, and the index of this thread.
#include "shared/layout.h"

// Constants of this dispatch alone, such as k and j of a sort pass. w: the first ball of a slice.
uniform uvec4 dispatch_constants;

// Beyond 65535 groups a dispatch is folded into rows of groups, one after the other. (A row's width is a constant:
// asking for gl_NumWorkGroups costs a dispatch of few balls 5 % on some devices.)
uint global_index() {
    return gl_GlobalInvocationID.y * (FOLDED_WIDTH * GROUP_SIZE) + gl_GlobalInvocationID.x;
}

// Where each thread looks at other balls a dispatch could take long: then it is cut into slices of balls.
uint sliced_index() { return dispatch_constants.w + global_index(); }

// The number of this work group, where each has a tile.
uint group_index() { return gl_WorkGroupID.y * FOLDED_WIDTH + gl_WorkGroupID.x; }
