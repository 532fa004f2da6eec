// What all drawing shaders know about the picture: one uniform block, read by GLSL and by C++ (view/frame.h).
// Colours are linear. A vec3 is followed by a 4-byte member, which makes std140 and C++ agree.

#define BLOCK_FRAME 1             // beside BLOCK_PARAMS of layout.h

#define SEQUENTIAL_COLOURS 9
#define DIVERGING_COLOURS 9
#define CATEGORICAL_COLOURS 8

#define COLOUR_TINTED 0u          // view::BallColour
#define COLOUR_PLAIN 1u
#define COLOUR_SPEED 2u
#define COLOUR_CELL 3u

#define FAR_BELOW 6.0             // pixels across below which a ball is far

// Balls drawn pixel by pixel (view/pixel_balls.h): storage buffers and sizes of work groups.
#define BINDING_DRAWN_POSITIONS 0
#define BINDING_DRAWN_VELOCITIES 1
#define BINDING_DRAWN_VALUES 2
#define BINDING_PIXELS 3
#define BINDING_NEAR_BALLS 4
#define BINDING_NEAR_DRAWS 5
#define PIXEL_BALLS_GROUP_SIZE 256  // balls
#define PIXELS_GROUP_WIDTH 16       // pixels each way
#define NO_BALL 0xFFFFFFFFu
#define NEAR_DRAW_WORDS 5         // of a command of glDraw*Indirect; the second one is the number of instances

#define PALETTE_SEQUENTIAL 0u     // view::Palette
#define PALETTE_DIVERGING 1u
#define PALETTE_CATEGORICAL 2u

struct FrameParams {
    mat4 view_projection;
    vec3 eye;                     // m
    float pixels_per_radian;      // at the picture's middle
    vec3 light_position;          // m
    float ambient;
    vec3 light_colour;            // times intensity
    float light_distance;         // m: from here the light has its full colour; nearer it is brighter
    vec3 box_lower;               // m: corners of the box where it stands
    float ground_spacing;         // m between the ground's lines
    vec3 box_upper;
    float ground_reach;           // m of ground around the box
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
    vec2 picture_origin;          // pixels from the framebuffer's lower left corner
    float value_low;              // value that gets the palette's first colour
    float value_high;             // and its last
    vec3 no_value_colour;
    uint value_palette;
    vec3 slice_normal;            // along an axis, towards the eye; 0 without a slice
    float slice_place;            // m: dot(slice_normal, point) of the slice's plane
    uint slice_axis;
    uint slice_layer;
    float cut_away;               // 1: balls beyond the slice's plane are left out
    float arrow_seconds;
    vec4 sequential[SEQUENTIAL_COLOURS];
    vec4 diverging[DIVERGING_COLOURS];
    vec4 categorical[CATEGORICAL_COLOURS];
};
