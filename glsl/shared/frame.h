// What all drawing shaders know about the picture: one uniform block, read by GLSL and by C++ (view/frame.h).
// Colours are linear. A vec3 is followed by a 4-byte member, which makes std140 and C++ agree.

#define BLOCK_FRAME 1             // beside BLOCK_PARAMS of layout.h

#define SEQUENTIAL_COLOURS 9
#define CATEGORICAL_COLOURS 8

#define COLOUR_TINTED 0u          // view::BallColour
#define COLOUR_PLAIN 1u
#define COLOUR_SPEED 2u
#define COLOUR_CELL 3u

struct FrameParams {
    mat4 view_projection;
    vec3 eye;                     // m
    float pixels_per_radian;      // at the picture's middle
    vec3 light_position;          // m
    float ambient;
    vec3 light_colour;            // times intensity
    float light_distance;         // m: from here the light has its full colour; nearer it is brighter
    vec3 half_extent;             // m
    float ground_spacing;         // m between the ground's lines
    vec3 grid_origin;             // m
    float cell_width;             // m
    uvec3 grid_cells;
    float top_count;              // balls in a cell that get the last colour
    vec3 camera_right;
    float top_speed;              // m/s that gets the last colour
    vec3 camera_up;
    uint ball_colour;
    vec2 picture_size;            // pixels
    float marker_radius;          // m
    float shadow_range;           // m that the shadow map's depth spans; 0: no shadows
    vec4 sequential[SEQUENTIAL_COLOURS];
    vec4 categorical[CATEGORICAL_COLOURS];
};
