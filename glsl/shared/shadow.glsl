// What the light sees, unrolled from the half-space below it onto a disc (a paraboloid map, Brabec and others 2002):
// one picture serves every place below the light, however wide the box. Needs shared/frame.glsl.

const float shadow_horizon = -0.02;      // z of the flattest direction that the map holds

// Where a direction (unit, away from the light) falls in the map, from -1 to 1.
vec2 shadow_place(vec3 direction) { return direction.xy / (1.0 - direction.z); }
