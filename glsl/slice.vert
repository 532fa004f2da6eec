#version 330 core
// A square for each cell of one layer of the grid.
#include "shared/frame.glsl"

uniform usamplerBuffer elements;         // first slot and one past the last, of every cell

out vec2 local;                          // -1 to 1 in the cell, as the reader holds the page
flat out vec4 shade;                     // w: 0 at no ball, 1 at top_count
flat out uint count;

void main() {
    int axis = int(frame.slice_axis);
    int second = (axis + 1) % 3;
    int third = (axis + 2) % 3;
    uvec3 cell;
    cell[axis] = frame.slice_layer;
    cell[second] = uint(gl_InstanceID) % frame.grid_cells[second];
    cell[third] = uint(gl_InstanceID) / frame.grid_cells[second];
    uint id = (cell.z * frame.grid_cells.y + cell.y) * frame.grid_cells.x + cell.x;
    uvec2 range = texelFetch(elements, int(id)).xy;
    count = range.y - range.x;

    vec2 corner = vec2((gl_VertexID & 1) != 0 ? 1.0 : -1.0, (gl_VertexID & 2) != 0 ? 1.0 : -1.0);
    vec3 place = frame.grid_origin + frame.cell_width * (vec3(cell) + 0.5);
    place[axis] = frame.slice_normal[axis] * frame.slice_place;
    place[second] += 0.5 * frame.cell_width * corner.x;
    place[third] += 0.5 * frame.cell_width * corner.y;

    // Numbers are to stand upright: to the right along the axis that comes nearest to the picture's right.
    vec3 page_right = vec3(0.0);
    float to_second = frame.camera_right[second];
    float to_third = frame.camera_right[third];
    page_right[abs(to_second) >= abs(to_third) ? second : third] =
        (abs(to_second) >= abs(to_third) ? to_second : to_third) < 0.0 ? -1.0 : 1.0;
    vec3 page_up = cross(frame.slice_normal, page_right);
    local = vec2(page_right[second] * corner.x + page_right[third] * corner.y,
                 page_up[second] * corner.x + page_up[third] * corner.y);

    float fullness = clamp((float(count) - 1.0) / max(frame.top_count - 1.0, 1.0), 0.0, 1.0);
    shade = vec4(sequential_colour(fullness), fullness);
    gl_Position = frame.view_projection * vec4(place, 1.0);
}
