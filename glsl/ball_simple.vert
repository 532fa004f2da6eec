#version 330 core
// One point a ball, for a CPU that draws: a vertex and a square of pixels. Everything that is the same all over the ball
// is worked out here, in the camera's axes.
#include "shared/frame.glsl"
#include "shared/ball.glsl"
#include "shared/ball_value.glsl"

layout(location = 3) in vec4 state;      // centre, radius
layout(location = 4) in vec4 velocity;   // velocity, mass

uniform sampler2D surface;
uniform vec3 diffuse;
uniform vec2 margins;                    // share of the viewport that the picture fills: points beyond it reach into it

flat out vec4 sphere;                    // centre, radius
flat out vec4 paint;                     // its colour; width of the point, m at the centre's depth
flat out vec4 lamp;                      // where the light is (unit), and how much of it arrives

void main() {
    vec4 ball = whole_ball(state);
    vec3 away = ball.xyz - frame.eye;
    vec3 ahead = cross(frame.camera_up, frame.camera_right);
    mat3 camera = transpose(mat3(frame.camera_right, frame.camera_up, ahead));
    sphere = vec4(camera * away, ball.w);
    vec4 place = frame.view_projection * vec4(ball.xyz, 1.0);
    if (!is_finite(ball) || sphere.z <= ball.w) {
        gl_Position = nowhere;
        gl_PointSize = 1.0;
        return;
    }
    gl_Position = vec4(place.xy * margins, place.zw);
    float pixel = pixel_at(sphere.z);
    // Beside the middle of the picture a sphere is seen longer than wide: it ends where the ray to its centre, turned by
    // half the angle that it takes up, meets the picture.
    float squared = dot(sphere.xyz, sphere.xyz);
    float cosine = (sphere.z * sqrt(squared - ball.w * ball.w) - length(sphere.xy) * ball.w) / squared;
    float size = 2.0 * ball.w / (pixel * max(cosine, 0.1)) + 1.0;
    gl_PointSize = size;
#ifdef VALUED
    vec4 tint = vec4(value_colour(value), 1.0);
#else
    vec4 tint = ball_tint(uint(gl_VertexID), ball.xyz, velocity.xyz);
#endif
    if (state.w < 0.0) {
        tint = quarantine_tint;
    }
    // Of the texture only its mean is seen, its smallest level: the tint takes its place, or there would be no telling
    // neighbours apart. White is none.
    vec3 own = textureLod(surface, vec2(0.5), 100.0).rgb * diffuse;
    float lightness = dot(own, vec3(0.2126, 0.7152, 0.0722));
    bool plain = tint == vec4(1.0, 1.0, 1.0, 0.0);
    vec3 albedo = plain ? own : tint.rgb * (0.45 + 0.55 * lightness);
    vec3 offset = frame.light_position - ball.xyz;
    float ratio = length(offset) / frame.light_distance;
    lamp = vec4(camera * normalize(offset), 2.0 / (1.0 + ratio * ratio));
    paint = vec4(albedo, size * pixel);
}
