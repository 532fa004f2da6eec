// Draws the overlay's lines, highlights and slice. Arrows are the balls' own (ball_drawing.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

#include "gl/buffer.h"
#include "gl/buffer_texture.h"
#include "gl/program.h"
#include "gl/vertex_array.h"
#include "view/picture.h"

namespace ballpit::view {

class OverlayDrawing {
public:
    explicit OverlayDrawing(const std::filesystem::path& shader_folder);

    /// First of all, for the picture that the following calls draw.
    void prepare(const Picture& picture);
    /// What is seen, or, `through`, what shows faintly through the balls before it.
    void draw(const Picture& picture, bool through);

private:
    // As highlight.vert reads it.
    struct Ring {
        std::uint32_t ball;
        vec4 colour;
    };

    void prepare_lines(const Picture& picture);
    void prepare_rings(const Picture& picture);
    void draw_tether(const Tether& tether, bool through);

    gl::Program line_program_;
    gl::Program highlight_program_;
    gl::Program slice_program_;
    gl::Program tether_program_;
    gl::BufferTexture elements_;
    std::size_t readable_elements_;
    gl::VertexArray line_array_;
    gl::VertexArray ring_array_;
    gl::VertexArray no_attributes_;
    gl::Buffer line_buffer_;
    gl::Buffer ring_buffer_;
    std::size_t lines_ = 0;
    std::size_t rings_ = 0;
    std::size_t slice_cells_ = 0;
    bool tethered_ = false;
};

}  // namespace ballpit::view
