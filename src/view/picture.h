// What is to be drawn, as plain data.
#pragma once

#include <cstdint>

#include "core/grid.h"
#include "gl/buffer.h"
#include "view/camera.h"
#include "view/light.h"
#include "view/overlay.h"
#include "view/palette.h"

namespace ballpit::view {

enum class Look : std::uint8_t {
    model,     // the OBJ model, an instance a ball
    impostor,  // a square a ball, its sphere found by ray: cheaper where triangles are dear
    simple,    // a point a ball, its sphere found by ray, in one colour; no shadows, a plain ground: where a CPU draws
};

enum class BallColour : std::uint8_t {
    tinted,  // texture, with a tint a ball that tells neighbours apart
    plain,   // texture only
    speed,   // sequential palette, 0 to `top_speed`; needs velocities
    cell,    // categorical palette by grid cell
    value,   // `values` by `value_palette`; needs values
};

/// Everything that one picture shows. The buffers must have been written before, as the draw sees them (GPU
/// backend: after a barrier for vertex attributes and storage), and stay the caller's.
struct Picture {
    const gl::Buffer* positions = nullptr;   // vec4 a ball: centre (m), radius (m); null only without balls
    const gl::Buffer* velocities = nullptr;  // vec4 a ball: velocity (m/s), mass (kg); may be null
    std::uint32_t ball_count = 0;
    // std::uint32_t each: the numbers of the balls to draw, in the order in which they are best drawn; null for all of
    // them in any order. Only the simple look asks.
    const gl::Buffer* order = nullptr;
    std::uint32_t order_count = 0;
    const gl::Buffer* cell_ranges = nullptr;  // CellRange a cell of `grid`; may be null
    Grid grid;
    Box box{vec3(-10.0f), vec3(10.0f)};  // m, where it stands
    // m: of a room around the origin that holds the box wherever it is; camera, light and shadows go by it.
    vec3 half_extent{10.0f};
    Camera camera;
    Light light;
    Look look = Look::model;
    BallColour ball_colour = BallColour::tinted;
    float top_speed = 10.0f;  // m/s
    bool show_box = true;
    bool show_ground = true;
    bool show_light = true;
    bool show_shadows = true;     // none in the simple look
    bool show_cells = false;      // occupied cells, coloured by count
    std::uint32_t top_count = 8;  // balls in a cell that get the sequential palette's last colour

    // For BallColour::value. NaN is grey.
    const gl::Buffer* values = nullptr;  // float a ball
    Palette value_palette = Palette::sequential;
    float value_low = 0.0f;  // first and last colour; the categorical palette takes whole numbers and needs no range
    float value_high = 1.0f;

    const Overlay* overlay = nullptr;  // may be null
    float time_s = 0.0f;               // what blinks goes by this

    // Where in the framebuffer, pixels from its lower left corner; nothing outside is touched.
    int x = 0;
    int y = 0;
    int width = 1280;
    int height = 720;
};

}  // namespace ballpit::view
