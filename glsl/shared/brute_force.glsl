// Adds up all other balls, in the order of their ids: no grid, n^2 pairs. There to be compared with. What add_pair()
// does to the NEIGHBOUR_SUM is its own.

void add_neighbours(Ball a, inout NEIGHBOUR_SUM sum) {
    for (uint id = 0u; id < params.ball_count; ++id) {
        if (id != a.id) {
            add_pair(a, id, sum);
        }
    }
}
