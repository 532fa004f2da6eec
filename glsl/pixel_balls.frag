#version 430 core
// Each pixel's ball, as the impostor has it: light is worked out only for what is seen.
#define BY_NUMBER
#include "shared/frame.glsl"
#include "shared/ball.glsl"
#include "shared/ball_value.glsl"
#include "shared/lighting.glsl"
#include "shared/ball_surface.glsl"
#include "shared/sphere_surface.glsl"
#include "shared/pixel_balls.glsl"

layout(std430, binding = BINDING_DRAWN_VELOCITIES) readonly buffer VelocityBlock { vec4 velocities[]; };
#ifdef VALUED
layout(std430, binding = BINDING_DRAWN_VALUES) readonly buffer ValueBlock { float values[]; };
#endif

layout(location = 0) out vec4 colour;

vec4 tint_of(uint id, vec4 state) {
    if (state.w < 0.0) {
        return quarantine_tint;
    }
#ifdef VALUED
    return vec4(value_colour(values[id]), 1.0);
#else
    return ball_tint(id, state.xyz, velocities[id].xyz);
#endif
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy - frame.picture_origin);
    uint id = pixels[pixel_index(pixel)].ball;
    if (id == NO_BALL) {
        discard;
    }
    vec4 state = positions[id];
    vec4 ball = whole_ball(state);
    mat3 axes = camera_axes();
    vec3 ray = pixel_ray(pixel);
    Meeting met = meet(ray, (ball.xyz - frame.eye) * axes, ball.w);
    vec3 normal = normalize(axes * (met.miss - met.along * ray));
    vec3 place = ball.xyz + ball.w * normal;
    vec4 clip = frame.view_projection * vec4(place, 1.0);
    gl_FragDepth = 0.5 + 0.5 * clip.z / clip.w;
    // The pattern of the texture goes as the ball gets smaller, before pixels meet it here and there only.
    float away = distance(ball.xyz, frame.eye);
    float size = 2.0 * ball.w / pixel_at(away);
    float scale = texels_a_pixel(ball.w, away) * exp2(2.0 * max(FAR_BELOW - size, 0.0));
    colour = vec4(ball_colour(sphere_texel(ball_turn(id), normal, scale), tint_of(id, state), place, normal), 1.0);
}
