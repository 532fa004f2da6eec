// From a point to its cell.

// Points outside the box belong to the outermost cells, NaN to cell 0. Clamped as a number, before the
// conversion: a float out of range has no defined integer.
uvec3 cell_coordinates(vec3 point) {
    precise vec3 scaled = (point - params.grid_origin) * params.inverse_cell_width;
    vec3 coordinate = floor(scaled);
    vec3 last = vec3(params.grid_cells - 1u);
    return uvec3(isnan(coordinate.x) ? 0.0 : clamp(coordinate.x, 0.0, last.x),
                 isnan(coordinate.y) ? 0.0 : clamp(coordinate.y, 0.0, last.y),
                 isnan(coordinate.z) ? 0.0 : clamp(coordinate.z, 0.0, last.z));
}

uint cell_id(uvec3 cell) { return (cell.z * params.grid_cells.y + cell.y) * params.grid_cells.x + cell.x; }
