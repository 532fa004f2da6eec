// The contact force of one ball on another. `place`: where in `positions` and `velocities` the other one is.

// Its id, which in the sorted copies only its key knows.
uint ball_at(uint place) {
#ifdef SORTED_COPIES
    return keys[place].ball_id;
#else
    return place;
#endif
}

uint id_of(Ball a) {
#ifdef SORTED_COPIES
    return ball_at(a.place);   // asked for only where it matters
#else
    return a.id;
#endif
}

float ordered_dot(vec3 a, vec3 b) {
    precise float sum = a.x * b.x + a.y * b.y + a.z * b.z;   // dot() may add in any order
    return sum;
}

// Balls with the same centre have no line of centres. Both of a pair derive one axis from their ids and take
// opposite ends of it, so that momentum is still conserved.
vec3 coincident_direction(uint id, uint other) {
    uint axis = (id + other) % 3u;
    float end = id < other ? 1.0 : -1.0;
    return vec3(axis == 0u ? end : 0.0, axis == 1u ? end : 0.0, axis == 2u ? end : 0.0);
}

// Of the other ball only the position is read, until it is known to touch; without a dashpot, nothing else at all.
float pair_force(Ball a, uint place, vec3 normal, float overlap) {
#ifdef LAW_DASHPOT
    vec4 velocity = velocities[place];
#ifdef QUARANTINE
    if (!can_be_squared(velocity.xyz)) {
        return 0.0;   // it goes into quarantine in this very substep
    }
#endif
    float mass = mass_of(velocity);
    precise float reduced_mass = a.mass * mass / (a.mass + mass);
    precise float speed = ordered_dot(a.velocity - velocity.xyz, normal);
    return damped_force(overlap, speed, reduced_mass, max(a.damping_ratio, damping_ratio_of(ball_at(place))));
#else
    return spring_force(overlap);
#endif
}

#ifdef SORTED_COPIES
// Whether touches() would find a contact, or would without quarantine: the same arithmetic.
bool within_reach(Ball a, uint place) {
    vec4 position = positions[place];
    precise vec3 offset = a.position - position.xyz;
    precise float reach = a.radius + radius_of(position);
    precise float reach_squared = reach * reach;
    return ordered_dot(offset, offset) < reach_squared;
}
#endif

// A contact, where there is one: its normal, away from the other ball, the overlap (m), and the sum of the radii (m).
bool touches(Ball a, uint place, out vec3 normal, out float overlap, out float radii) {
    vec4 position = positions[place];
    precise vec3 offset = a.position - position.xyz;
    precise float reach = a.radius + radius_of(position);
    precise float distance_squared = ordered_dot(offset, offset);
    precise float reach_squared = reach * reach;
    radii = reach;
#ifdef QUARANTINE
    bool held = position.w < 0.0;   // one in quarantine touches nobody; asked of those alone that would touch
#else
    const bool held = false;
#endif
    if (distance_squared < reach_squared && !held) {   // false for NaN
#ifdef DIAGNOSTICS
        if (distance_squared == 0.0 && id_of(a) < ball_at(place)) {
            atomicOr(status.bits, STATUS_COINCIDENT);
            atomicAdd(status.coincident, 1u);
        }
#endif
        float separation = sqrt(distance_squared);
        precise vec3 direction =
            distance_squared > 0.0 ? offset / separation : coincident_direction(id_of(a), ball_at(place));
        precise float depth = reach - separation;
        normal = direction;
        overlap = depth;
        return true;
    }
    normal = vec3(0.0);
    overlap = 0.0;
    return false;
}

void add_pair(Ball a, uint place, inout vec3 force) {
    vec3 normal;
    float overlap;
    float radii;
    if (touches(a, place, normal, overlap, radii)) {
        precise vec3 sum = force + pair_force(a, place, normal, overlap) * normal;
        force = sum;
    }
}
