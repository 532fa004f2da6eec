// Draws a picture from the physics' own buffers: nothing is read back, nothing is copied.
// Needs OpenGL 3.3 only, so that a machine without compute shaders shows the CPU mirror's balls the same way.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "core/grid.h"
#include "gl/buffer.h"
#include "view/camera.h"
#include "view/light.h"
#include "view/model.h"

namespace ballpit::view {

enum class Look : std::uint8_t {
    model,     // the OBJ model, an instance a ball
    impostor,  // a square a ball, its sphere found by ray: cheaper where triangles are dear
};

enum class BallColour : std::uint8_t {
    tinted,  // texture, with a tint a ball that tells neighbours apart
    plain,   // texture only
    speed,   // sequential palette, 0 to `top_speed`; needs velocities
    cell,    // categorical palette by grid cell
};

/// Everything that one picture shows. The buffers must have been written before, as the draw sees them (GPU
/// backend: after a barrier for vertex attributes), and stay the caller's.
struct Picture {
    const gl::Buffer* positions = nullptr;   // vec4 a ball: centre (m), radius (m)
    const gl::Buffer* velocities = nullptr;  // vec4 a ball: velocity (m/s), mass (kg); may be null
    std::uint32_t ball_count = 0;
    const gl::Buffer* cell_ranges = nullptr;  // CellRange a cell of `grid`; may be null
    Grid grid;
    vec3 half_extent{10.0f};  // m
    Camera camera;
    Light light;
    Look look = Look::model;
    BallColour ball_colour = BallColour::tinted;
    float top_speed = 10.0f;  // m/s
    bool show_box = true;
    bool show_ground = true;
    bool show_light = true;
    bool show_cells = false;      // occupied cells, coloured by count
    std::uint32_t top_count = 8;  // balls in a cell that get the sequential palette's last colour
    int width = 1280;             // pixels
    int height = 720;
};

class Renderer {
public:
    /// Reads the drawing shaders of `shader_folder`. Throws gl::ShaderError or gl::Error.
    Renderer(const std::filesystem::path& shader_folder, const Model& ball_model);
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    void set_model(const Model& ball_model);

    /// Fills the bound framebuffer from its lower left corner, width x height pixels, colour and depth. Leaves
    /// depth test, culling and blending off. A ball whose position or radius is not finite is not drawn.
    void draw(const Picture& picture);

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace ballpit::view
