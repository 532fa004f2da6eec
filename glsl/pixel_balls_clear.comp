#version 430 core
#include "shared/frame.glsl"
#include "shared/pixel_balls.glsl"

layout(local_size_x = PIXELS_GROUP_WIDTH, local_size_y = PIXELS_GROUP_WIDTH) in;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(pixel, ivec2(frame.picture_size)))) {
        pixels[pixel_index(pixel)] = PixelBall(0xFFFFFFFFu, NO_BALL);
    }
}
