#version 330 core
// The sphere by ray, as the impostor has it. Depth is the centre's all over the ball: written early, so that nothing is
// worked out of a ball behind another one. Of two balls that do not overlap the one with the nearer centre hides the
// other, but for a sliver far from the picture's middle.
#include "shared/frame.glsl"

flat in vec4 sphere;
flat in vec4 paint;
flat in vec4 lamp;

layout(location = 0) out vec4 colour;

// sRGB within 0.02: two roots instead of a power.
vec3 nearly_srgb(vec3 linear) {
    vec3 root = sqrt(min(linear, vec3(1.0)));
    return 0.5851 * root + 0.7831 * sqrt(root) - 0.3683 * root * root;
}

void main() {
    vec2 across = (gl_PointCoord - 0.5) * vec2(paint.w, -paint.w);
    vec3 ray = vec3(sphere.xy + across, sphere.z);
    float squared = dot(ray, ray);
    vec3 miss = vec3(across, 0.0) - dot(across, ray.xy) / squared * ray;   // from the centre to the ray
    float depth_squared = sphere.w * sphere.w - dot(miss, miss);
    if (depth_squared < 0.0) {
        discard;
    }
    vec3 normal = (miss - sqrt(depth_squared / squared) * ray) / sphere.w;
    vec3 upwards = vec3(frame.camera_right.z, frame.camera_up.z,
                        frame.camera_up.x * frame.camera_right.y - frame.camera_up.y * frame.camera_right.x);
    float sky = 0.5 + 0.5 * dot(normal, upwards);
    vec3 everywhere = frame.ambient * mix(vec3(0.32, 0.30, 0.30), vec3(0.95, 1.0, 1.08), sky);
    vec3 light = everywhere + max(dot(normal, lamp.xyz), 0.0) * lamp.w * frame.light_colour;
    colour = vec4(nearly_srgb(paint.rgb * light), 1.0);
}
