#version 330 core
// A cube for each occupied cell, as one strip of 14 vertices; the cell follows from the instance's number.
#include "shared/frame.glsl"

layout(location = 3) in uvec2 range;     // CellRange: first slot, one past the last

out vec3 local;                          // -1 to 1 in the cell
flat out vec4 shade;                    // w: 0 at one ball, 1 at top_count

const float size = 0.94;                 // of the cell, so that neighbours' lines do not fall together

void main() {
    uint count = range.y - range.x;
    if (count == 0u) {
        gl_Position = nowhere;
        return;
    }
    // Bit v of each number is a coordinate of vertex v of the strip.
    ivec3 bits = (ivec3(0x217A, 0x0BD0, 0x071C) >> gl_VertexID) & 1;
    local = 2.0 * vec3(bits) - 1.0;
    uint id = uint(gl_InstanceID);
    uvec3 cell = uvec3(id % frame.grid_cells.x, id / frame.grid_cells.x % frame.grid_cells.y,
                       id / (frame.grid_cells.x * frame.grid_cells.y));
    vec3 place = frame.grid_origin + frame.cell_width * (vec3(cell) + 0.5 + 0.5 * size * local);
    float fullness = clamp((float(count) - 1.0) / max(frame.top_count - 1.0, 1.0), 0.0, 1.0);
    shade = vec4(sequential_colour(fullness), fullness);
    gl_Position = frame.view_projection * vec4(place, 1.0);
}
