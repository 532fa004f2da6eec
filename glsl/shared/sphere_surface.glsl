// The texture of a ball whose surface is found by ray. Needs shared/ball.glsl and shared/ball_surface.glsl.

// Longitude and polar angle, as the ball model maps them.
vec2 sphere_uv(vec3 n) {
    const float pi = 3.14159265;
    return vec2(atan(n.y, n.x) / (2.0 * pi), acos(clamp(n.z, -1.0, 1.0)) / pi);
}

// The level is given (texels_a_pixel): the jump of the longitude would make derivatives choose the smallest one.
vec3 sphere_texel(vec4 turn, vec3 normal, float scale) {
    float level = log2(max(scale * float(textureSize(surface, 0).y), 1.0));
    return textureLod(surface, sphere_uv(turned(vec4(-turn.xyz, turn.w), normal)), level).rgb;
}
