// How surfaces answer the light: Lambert and Blinn-Phong from the point light, and light from everywhere, a little
// bluer and stronger from above. Needs shared/frame.glsl.
#include "shared/shadow.glsl"

uniform sampler2DShadow shadow_map;

const float shade = 0.3;

// Light that arrives at `place`: falls with distance as from a lamp of some size, never to nothing, so that a corner
// far from the light can still be read.
vec3 arriving_light(vec3 place) {
    float ratio = distance(place, frame.light_position) / frame.light_distance;
    return frame.light_colour * (2.0 / (1.0 + ratio * ratio));
}

// Share of the light that gets there past the balls; four comparisons around the place make the edge soft. A shade
// keeps some light, so that what lies in it can still be told apart.
float unshaded(vec3 place) {
    vec3 from_light = place - frame.light_position;
    float away = length(from_light);
    vec3 direction = from_light / away;
    if (frame.shadow_range == 0.0 || direction.z > shadow_horizon) {
        return 1.0;
    }
    vec2 middle = 0.5 + 0.5 * shadow_place(direction);
    float pixel = 1.0 / float(textureSize(shadow_map, 0).x);
    float depth = away / frame.shadow_range;
    float share = 0.0;
    for (int i = 0; i < 4; ++i) {
        vec2 offset = vec2((i & 1) == 0 ? -0.8 : 0.8, (i & 2) == 0 ? -0.8 : 0.8);
        share += texture(shadow_map, vec3(middle + pixel * offset, depth));
    }
    return mix(shade, 1.0, 0.25 * share);
}

vec3 ambient_light(vec3 normal) {
    float sky = 0.5 + 0.5 * normal.z;
    return frame.ambient * mix(vec3(0.32, 0.30, 0.30), vec3(0.95, 1.0, 1.08), sky);
}

vec3 lit(vec3 albedo, vec3 specular, float shininess, vec3 place, vec3 normal) {
    vec3 to_light = normalize(frame.light_position - place);
    vec3 to_eye = normalize(frame.eye - place);
    vec3 light = arriving_light(place) * unshaded(place);
    float facing = max(dot(normal, to_light), 0.0);
    vec3 colour = albedo * (ambient_light(normal) + light * facing);
    if (facing > 0.0) {
        float glance = max(dot(normal, normalize(to_light + to_eye)), 0.0);
        colour += specular * light * pow(glance, shininess);
    }
    return colour;
}
