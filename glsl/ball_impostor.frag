#version 330 core
#include "shared/frame.glsl"
#include "shared/ball.glsl"
#include "shared/lighting.glsl"
#include "shared/ball_surface.glsl"
#include "shared/sphere_surface.glsl"

#ifdef FADED
flat in float shown;
#define OPACITY shown
#else
#define OPACITY 1.0
#endif

in vec3 ray;
flat in vec4 sphere;
flat in vec4 tint;
flat in vec4 turn;
flat in float texel_scale;

layout(location = 0) out vec4 colour;

void main() {
    vec3 direction = normalize(ray);
    vec3 to_centre = sphere.xyz - frame.eye;
    float nearest = dot(to_centre, direction);
    // From the centre to the ray: no difference of large squares, so that far balls stay round.
    vec3 miss = nearest * direction - to_centre;
    float depth_squared = sphere.w * sphere.w - dot(miss, miss);
    if (depth_squared < 0.0) {
        discard;
    }
    vec3 from_centre = miss - sqrt(depth_squared) * direction;
    vec3 place = sphere.xyz + from_centre;
    vec4 clip = frame.view_projection * vec4(place, 1.0);
    gl_FragDepth = 0.5 + 0.5 * clip.z / clip.w;
    vec3 normal = from_centre / sphere.w;
    colour = vec4(ball_colour(sphere_texel(turn, normal, texel_scale), tint, place, normal), OPACITY);
}
