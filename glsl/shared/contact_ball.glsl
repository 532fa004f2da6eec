// A ball, as the laws that the scene declares see it. Needs shared/contact.glsl where it has a spring.
struct Ball {
    uint id;
#ifdef SORTED_COPIES
    uint place;                  // its slot
#endif
    vec3 position;
    vec3 velocity;
#ifdef LAW_SPRING
    float radius;
    float mass;
#endif
#ifdef LAW_DASHPOT
    float damping_ratio;
#endif
#ifdef LAW_COMPENSATED
    vec3 left_out;               // of the position
#endif
};

Ball make_ball(uint id, vec4 position, vec4 velocity) {
    Ball ball;
    ball.id = id;
    ball.position = position.xyz;
    ball.velocity = velocity.xyz;
#ifdef LAW_SPRING
    ball.radius = radius_of(position);
    ball.mass = mass_of(velocity);
#endif
#ifdef LAW_DASHPOT
    ball.damping_ratio = damping_ratio_of(id);
#endif
    return ball;
}
