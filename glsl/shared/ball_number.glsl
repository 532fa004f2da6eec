// The number of the ball that is drawn: the instance's, unless instances come from a list (view/pixel_balls.h).
#ifdef LISTED
layout(location = 7) in uint number;
uint ball_number() { return number; }
#else
uint ball_number() { return uint(gl_InstanceID); }
#endif
