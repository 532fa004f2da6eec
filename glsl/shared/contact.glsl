// The contact law, for balls and walls alike.

#ifdef LAW_BALL_RESTITUTION
layout(std430, binding = SLOT_DAMPING_RATIOS) readonly buffer DampingRatiosBlock { float damping_ratios[]; };
#endif

Ball load_ball(uint id) {
    vec4 p = positions[id];
    vec4 v = velocities[id];
#ifdef LAW_BALL_RESTITUTION
    float damping_ratio = damping_ratios[id];
#else
    float damping_ratio = params.damping_ratio;
#endif
    return Ball(id, p.xyz, p.w, v.xyz, v.w, damping_ratio);
}

float ordered_dot(vec3 a, vec3 b) {
    precise float sum = a.x * b.x + a.y * b.y + a.z * b.z;   // dot() may add in any order
    return sum;
}

// Force (N) along the contact normal: F = k * overlap - c * separation_speed, c = 2 zeta sqrt(k m_eff).
float contact_force(float overlap, float separation_speed, float reduced_mass, float damping_ratio) {
    precise float force = params.stiffness * overlap;
#ifdef LAW_DASHPOT
    precise float c = 2.0 * damping_ratio * sqrt(params.stiffness * reduced_mass);
    force = force - c * separation_speed;
#endif
#ifdef LAW_LIMIT_FORCE
    force = max(force, 0.0);
#endif
    return force;
}
