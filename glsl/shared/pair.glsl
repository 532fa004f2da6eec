// The contact force of one ball on another.

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
