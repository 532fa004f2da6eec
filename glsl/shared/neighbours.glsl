// Contact forces of the balls in the 27 cells around a ball, in the order of cells and slots.

layout(std430, binding = SLOT_CELL_RANGES) readonly buffer CellRangesBlock { CellRange cell_ranges[]; };

// Balls with the same centre have no line of centres. Both of a pair derive one axis from their ids and take
// opposite ends of it, so that momentum is still conserved.
vec3 coincident_direction(uint id, uint other) {
    uint axis = (id + other) % 3u;
    float end = id < other ? 1.0 : -1.0;
    return vec3(axis == 0u ? end : 0.0, axis == 1u ? end : 0.0, axis == 2u ? end : 0.0);
}

void add_pair(Ball a, Ball b, inout vec3 force) {
    precise vec3 offset = a.position - b.position;
    precise float reach = a.radius + b.radius;
    precise float distance_squared = ordered_dot(offset, offset);
    precise float reach_squared = reach * reach;
    if (distance_squared < reach_squared) {   // false for NaN
        float separation = sqrt(distance_squared);
        precise vec3 normal = distance_squared > 0.0 ? offset / separation : coincident_direction(a.id, b.id);
        precise float overlap = reach - separation;
        precise float reduced_mass = a.mass * b.mass / (a.mass + b.mass);
        precise float speed = ordered_dot(a.velocity - b.velocity, normal);
        float damping_ratio = max(a.damping_ratio, b.damping_ratio);
        precise vec3 sum = force + contact_force(overlap, speed, reduced_mass, damping_ratio) * normal;
        force = sum;
    }
}

void add_neighbours(Ball a, inout vec3 force) {
    uvec3 middle = cell_coordinates(a.position);
    uvec3 low = middle - min(middle, uvec3(1u));
    uvec3 high = min(middle + 1u, params.grid_cells - 1u);
    for (uint z = low.z; z <= high.z; ++z) {
        for (uint y = low.y; y <= high.y; ++y) {
            for (uint x = low.x; x <= high.x; ++x) {
                CellRange range = cell_ranges[cell_id(uvec3(x, y, z))];
                for (uint slot = range.first; slot < range.end; ++slot) {
                    uint id = keys[slot].ball_id;
                    if (id != a.id) {
                        add_pair(a, load_ball(id), force);
                    }
                }
            }
        }
    }
}
