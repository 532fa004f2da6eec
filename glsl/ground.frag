#version 330 core
#include "shared/frame.glsl"
#include "shared/lighting.glsl"
#include "shared/background.glsl"

in vec3 place;

layout(location = 0) out vec4 colour;

// 1 on a line through the multiples of `spacing`, blended to its share of the area where lines are too dense.
float lines(vec2 at, float spacing, float pixels) {
    vec2 u = at / spacing;
    vec2 width = fwidth(u);
    vec2 away = abs(fract(u - 0.5) - 0.5);
    vec2 cover = 1.0 - smoothstep(0.0, 1.0, away / max(width * pixels, 1e-6));
    cover *= 1.0 - smoothstep(0.15, 0.45, width);
    return max(cover.x, cover.y);
}

// Without light and shadow, for a CPU that draws.
#ifdef SIMPLE
const vec3 bare = vec3(0.27, 0.30, 0.33);
const vec3 lined = vec3(0.45, 0.48, 0.52);
vec3 surface_colour(float line) { return mix(bare, lined, line); }
#else
vec3 surface_colour(float line) {
    vec3 albedo = mix(vec3(0.11, 0.13, 0.16), vec3(0.36, 0.41, 0.48), line);
    return srgb(lit(albedo, vec3(0.0), 1.0, place, vec3(0.0, 0.0, 1.0)));
}
#endif

void main() {
    vec2 beyond = max(frame.box_lower.xy - place.xy, place.xy - frame.box_upper.xy);
    vec2 outside = max(beyond, 0.0) / frame.ground_reach;
    float presence = 1.0 - smoothstep(0.0, 1.0, length(outside));
    vec2 from_corner = place.xy - frame.box_lower.xy;
    float line = 0.35 * lines(from_corner, frame.ground_spacing, 1.0);
#ifndef SIMPLE
    line = max(line, 0.8 * lines(from_corner, 5.0 * frame.ground_spacing, 1.3));
#endif
    vec3 surface = surface_colour(line);
    float inside = outside == vec2(0.0) ? 1.0 : 0.7;
    colour = vec4(mix(background((gl_FragCoord.y - frame.picture_origin.y) / frame.picture_size.y), surface, inside * presence), 1.0);
}
