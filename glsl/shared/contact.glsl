// The contact law, for balls and walls alike.

float radius_of(vec4 position) {
#ifdef LAW_UNEQUAL_RADII
    return position.w;
#else
    return params.radius;
#endif
}

float mass_of(vec4 velocity) {
#ifdef LAW_UNEQUAL_MASSES
    return velocity.w;
#else
    return params.mass;
#endif
}

float spring_force(float overlap) {
    precise float force = params.stiffness * overlap;
    return force;
}

#ifdef LAW_DASHPOT
#ifdef LAW_BALL_RESTITUTION
layout(std430, binding = SLOT_DAMPING_RATIOS) readonly buffer DampingRatiosBlock { float damping_ratios[]; };
#endif

float damping_ratio_of(uint id) {
#ifdef LAW_BALL_RESTITUTION
    return damping_ratios[id];
#else
    return params.damping_ratio;
#endif
}

// N s/m: 2 zeta sqrt(k m_eff), or so much of it as a substep can follow (core/contact.h).
float dashpot(float damping_ratio, float reduced_mass) {
    precise float c = 2.0 * damping_ratio * sqrt(params.stiffness * reduced_mass);
#ifdef LAW_SEMI_IMPLICIT
    c = c / (1.0 + params.damping_time * c / reduced_mass);
#endif
    return c;
}

// Force (N) along the contact normal: F = k * overlap - c * separation_speed.
float damped_force(float overlap, float separation_speed, float reduced_mass, float damping_ratio) {
    float c = dashpot(damping_ratio, reduced_mass);
    precise float force = spring_force(overlap) - c * separation_speed;
#ifdef LAW_LIMIT_FORCE
    force = max(force, 0.0);
#endif
    return force;
}
#endif
