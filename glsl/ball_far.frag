#version 330 core
// A ball of a few pixels: its normals, but neither its own depth nor its texture.
#include "shared/frame.glsl"
#include "shared/lighting.glsl"
#include "shared/ball_surface.glsl"

flat in vec4 sphere;
flat in vec4 tint;
flat in float covers;

layout(location = 0) out vec4 colour;

const float coarsest = 20.0;             // level of the texture: its mean

void main() {
    vec2 across = vec2(2.0, -2.0) * (gl_PointCoord - 0.5);
    float squared = dot(across, across);
    if (squared > 1.0 && covers == 0.0) {
        discard;
    }
    float ahead = sqrt(max(1.0 - squared, 0.0));
    vec3 to_eye = cross(frame.camera_right, frame.camera_up);
    vec3 normal = normalize(across.x * frame.camera_right + across.y * frame.camera_up + ahead * to_eye);
    vec3 mean = textureLod(surface, vec2(0.5), coarsest).rgb;
    colour = vec4(ball_colour(mean, tint, sphere.xyz + sphere.w * normal, normal), 1.0);
}
