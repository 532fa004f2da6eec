// The frame block, and what follows from it alone.
#include "shared/frame.h"

layout(std140) uniform Frame {
    FrameParams frame;
};

// t from 0 to 1.
vec3 sequential_colour(float t) {
    float place = clamp(t, 0.0, 1.0) * float(SEQUENTIAL_COLOURS - 1);
    int below = min(int(place), SEQUENTIAL_COLOURS - 2);
    return mix(frame.sequential[below].rgb, frame.sequential[below + 1].rgb, place - float(below));
}

vec3 diverging_colour(float t) {
    float place = clamp(t, 0.0, 1.0) * float(DIVERGING_COLOURS - 1);
    int below = min(int(place), DIVERGING_COLOURS - 2);
    return mix(frame.diverging[below].rgb, frame.diverging[below + 1].rgb, place - float(below));
}

// The screen expects sRGB; done here, because not every framebuffer does it.
vec3 srgb(vec3 linear) {
    vec3 light = clamp(linear, 0.0, 1.0);
    return mix(12.92 * light, 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, greaterThan(light, vec3(0.0031308)));
}

// m that a pixel spans at this distance from the eye.
float pixel_at(float away) { return away / frame.pixels_per_radian; }

// A place outside every picture: vertices put there draw nothing.
const vec4 nowhere = vec4(2.0, 2.0, 2.0, 1.0);
