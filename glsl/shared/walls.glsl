// Contact forces of the box. Walls are half-spaces: the deeper the ball, the stronger the push, on both sides, up to
// wall_depth (core/wall_depth.h).

// `speed`: of the ball away from the wall.
float wall_force(float overlap, float speed, Ball ball) {
    if (!(overlap > 0.0)) {
        return 0.0;
    }
    float depth = min(overlap, params.wall_depth);
#ifdef DIAGNOSTICS
    if (depth < overlap) {
        atomicOr(status.bits, STATUS_CAPPED_WALL);
        atomicAdd(status.capped_walls, 1u);
    }
#endif
#ifdef LAW_DASHPOT
    return damped_force(depth, speed, ball.mass, ball.damping_ratio);
#else
    return spring_force(depth);
#endif
}

void add_walls(Ball ball, inout vec3 force) {
    precise vec3 low = ball.radius - (ball.position - params.box_lower);
    precise vec3 high = ball.radius - (params.box_upper - ball.position);
#ifdef LAW_COMPENSATED
    low = low - ball.left_out;   // a wall's place is exact, so the ball's may be, too
    high = high + ball.left_out;
#endif
    vec3 from_low = ball.velocity;
    vec3 from_high = ball.velocity;
#ifdef LAW_MOVING_WALLS
    from_low = ball.velocity - params.lower_velocity;
    from_high = ball.velocity - params.upper_velocity;
#endif
    for (int axis = 0; axis < 3; ++axis) {
        precise float pushed = force[axis] + wall_force(low[axis], from_low[axis], ball);
        pushed = pushed - wall_force(high[axis], -from_high[axis], ball);
        force[axis] = pushed;
    }
}
