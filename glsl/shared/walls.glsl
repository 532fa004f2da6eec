// Contact forces of the box. Walls are half-spaces: the deeper the ball, the stronger the push, on both sides.

float wall_force(float overlap, float separation_speed, Ball ball) {
    return overlap > 0.0 ? contact_force(overlap, separation_speed, ball.mass, ball.damping_ratio) : 0.0;
}

void add_walls(Ball ball, inout vec3 force) {
    precise vec3 low = ball.radius - (ball.position + params.half_extent);
    precise vec3 high = ball.radius - (params.half_extent - ball.position);
    for (int axis = 0; axis < 3; ++axis) {
        precise float pushed = force[axis] + wall_force(low[axis], ball.velocity[axis], ball);
        pushed = pushed - wall_force(high[axis], -ball.velocity[axis], ball);
        force[axis] = pushed;
    }
}
