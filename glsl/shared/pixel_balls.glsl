// Which ball each pixel of the picture shows, and how its ray meets that ball. In the camera's axes: right, up, and into
// the picture, from the eye. Needs shared/frame.glsl.

struct PixelBall {
    uint depth;                          // m into the picture, the bits of a float: they sort as the number does
    uint ball;                           // NO_BALL where there is none
};

layout(std430, binding = BINDING_DRAWN_POSITIONS) readonly buffer PositionBlock { vec4 positions[]; };
layout(std430, binding = BINDING_PIXELS) buffer PixelBlock { PixelBall pixels[]; };

mat3 camera_axes() { return mat3(frame.camera_right, frame.camera_up, cross(frame.camera_up, frame.camera_right)); }

// Through the middle of a pixel, 1 m into the picture.
vec3 pixel_ray(ivec2 pixel) {
    return vec3((vec2(pixel) + 0.5 - 0.5 * frame.picture_size) / frame.pixels_per_radian, 1.0);
}

uint pixel_index(ivec2 pixel) { return uint(pixel.y) * uint(frame.picture_size.x) + uint(pixel.x); }

struct Meeting {
    vec3 miss;                           // from the centre to where the ray comes nearest to it
    float inside;                        // how far within the sphere that is, squared; negative where the ray misses
    float along;                         // of the ray, from there back to the sphere
};

// No difference of large squares, so that far balls stay round.
Meeting meet(vec3 ray, vec3 centre, float radius) {
    float squared = dot(ray, ray);
    vec3 miss = dot(centre, ray) / squared * ray - centre;
    float inside = radius * radius - dot(miss, miss);
    return Meeting(miss, inside, sqrt(max(inside, 0.0) / squared));
}
