#version 430 core
// One thread a ball. Of those that are small in the picture: the nearest of each pixel that it covers. The others, as far
// as they may be seen, are listed to be drawn as usual, with all that drawing asks for. OpenGL 4.3 has no operation that
// compares a depth and keeps a number with it; so this runs twice, first for the depths, then for the balls that have
// them. Once for all of it, because only the same code is sure to give the same depth again. Of balls at the same depth
// the first one is shown, whoever comes first; of those that are listed, one or the other.
#include "shared/frame.glsl"
#include "shared/ball.glsl"
#include "shared/pixel_balls.glsl"

layout(local_size_x = PIXEL_BALLS_GROUP_SIZE) in;

struct NearBall {
    vec4 state;
    vec4 velocity;
    float value;
    uint number;
};

layout(std430, binding = BINDING_DRAWN_VELOCITIES) readonly buffer VelocityBlock { vec4 velocities[]; };
layout(std430, binding = BINDING_DRAWN_VALUES) readonly buffer ValueBlock { float values[]; };
layout(std430, binding = BINDING_NEAR_BALLS) writeonly buffer NearBlock { NearBall near_balls[]; };
layout(std430, binding = BINDING_NEAR_DRAWS) buffer DrawBlock { uint near_draws[]; };

uniform uint ball_count;
uniform uint draw_count;                 // commands that draw the list
uniform float near_from;                 // pixels across
uniform bool valued;
uniform bool naming;                     // the second run

const float square_below = 2.5;          // pixels across: from there on down the ray may miss what should be seen
const float disc_of_square = 1.1283792;  // a square of side 1 is as large as a disc of this diameter

// Where the sphere begins and ends in the picture along one of its axes, over the distance: the tangents from the eye.
vec2 ends(float side, float ahead, float radius) {
    float root = radius * sqrt(max(side * side + ahead * ahead - radius * radius, 0.0));
    return (side * ahead + vec2(-root, root)) / (ahead * ahead - radius * radius);
}

bool in_view(vec3 centre, float radius) {
    vec2 slope = 0.5 * frame.picture_size / frame.pixels_per_radian;
    vec2 beyond = (abs(centre.xy) - slope * centre.z) * inversesqrt(1.0 + slope * slope);   // of the picture's sides
    return centre.z > -radius && all(lessThan(beyond, vec2(radius)));
}

void list(uint id, vec4 state) {
    uint place = atomicAdd(near_draws[1], 1u);
    for (uint draw = 1u; draw < draw_count; ++draw) {
        atomicAdd(near_draws[NEAR_DRAW_WORDS * draw + 1u], 1u);
    }
    near_balls[place] = NearBall(state, velocities[id], valued ? values[id] : 0.0, id);
}

void main() {
    uint id = gl_GlobalInvocationID.x;
    if (id >= ball_count) {
        return;
    }
    vec4 state = positions[id];
    vec4 ball = whole_ball(state);
    vec3 centre = (ball.xyz - frame.eye) * camera_axes();
    if (!is_finite(ball) || !in_view(centre, ball.w)) {
        return;
    }
    float size = 2.0 * ball.w / pixel_at(length(centre));
    if (size >= near_from) {
        if (!naming) {
            list(id, state);
        }
        return;
    }
    vec2 across = frame.pixels_per_radian * ends(centre.x, centre.z, ball.w);
    vec2 upwards = frame.pixels_per_radian * ends(centre.y, centre.z, ball.w);
    bool square = size < square_below;
    if (square) {
        size /= disc_of_square;
        // A pixel is the least to be seen: of balls below that as many are shown as fill the pixels that they have.
        if (float(scrambled(id) & 0xFFFFu) / 65536.0 >= size * size) {
            return;
        }
        vec2 middle = centre.xy / centre.z * frame.pixels_per_radian;
        across = middle.x + 0.5 * max(size, 1.0) * vec2(-1.0, 1.0);
        upwards = middle.y + 0.5 * max(size, 1.0) * vec2(-1.0, 1.0);
    }
    vec2 edge = 0.5 * frame.picture_size - 0.5;
    ivec2 first = ivec2(ceil(clamp(edge + vec2(across.x, upwards.x), vec2(0.0), frame.picture_size)));
    ivec2 end = ivec2(ceil(clamp(edge + vec2(across.y, upwards.y), vec2(0.0), frame.picture_size)));
    for (int y = first.y; y < end.y; ++y) {
        for (int x = first.x; x < end.x; ++x) {
            vec3 ray = pixel_ray(ivec2(x, y));
            Meeting met = meet(ray, centre, ball.w);
            if (!square && met.inside < 0.0) {
                continue;
            }
            uint depth = floatBitsToUint(centre.z + met.miss.z - met.along);
            uint index = pixel_index(ivec2(x, y));
            if (!naming) {
                if (depth < pixels[index].depth) {
                    atomicMin(pixels[index].depth, depth);
                }
            } else if (depth == pixels[index].depth) {
                atomicMin(pixels[index].ball, id);
            }
        }
    }
}
