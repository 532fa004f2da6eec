// Draws a picture from the physics' own buffers: nothing is read back, nothing is copied.
// OpenGL 3.3 is enough, so that a machine without compute shaders shows the CPU mirror's balls the same way.
#pragma once

#include <filesystem>
#include <memory>

#include "view/model.h"
#include "view/passes.h"
#include "view/picture.h"

namespace ballpit::view {

class Renderer {
public:
    /// Reads the drawing shaders of `shader_folder`. computes: make use of compute shaders, where there are any, to
    /// draw many balls. Throws gl::ShaderError or gl::Error.
    Renderer(const std::filesystem::path& shader_folder, const Model& ball_model, bool computes = true);
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    void set_model(const Model& ball_model);

    /// Fills the picture's rectangle of the bound framebuffer, colour and depth, so that several pictures can stand
    /// side by side. Leaves depth test, culling, blending and scissor off. A ball whose position or radius is not
    /// finite is not drawn. `mark`, if any, is told of each pass.
    void draw(const Picture& picture, const PassMark& mark = {});

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace ballpit::view
