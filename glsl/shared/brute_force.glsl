// Contact forces of all other balls, in the order of their ids: no grid, n^2 pairs. There to be compared with.

void add_neighbours(Ball a, inout vec3 force) {
    for (uint id = 0u; id < params.ball_count; ++id) {
        if (id != a.id) {
            add_pair(a, id, force);
        }
    }
}
