// Many balls, of which most are small in the picture. Compute shaders find the ball that each pixel shows, and only
// that one is lit; balls that are larger are listed, to be drawn as usual. Triangles and points of a few pixels would
// be worked out as a whole and be mostly hidden; and some devices compute with far more of their processors than they
// draw with (an H100 draws with one in 33).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "gl/program.h"
#include "gl/vertex_array.h"
#include "view/frame.h"
#include "view/picture.h"

namespace ballpit::view {

/// What glDrawElementsIndirect reads; of glDrawArraysIndirect the first four: count, instances, first, 0.
using NearDraw = std::array<std::uint32_t, NEAR_DRAW_WORDS>;

/// A ball of the list, as shaders get it: an instance each.
struct NearBall {
    vec4 state;  // centre, radius
    vec4 velocity;
    float value;
    std::uint32_t number;
    std::array<std::uint32_t, 2> padding;
};

class PixelBalls {
public:
    /// Whether this context has what it takes: OpenGL 4.3.
    static bool possible();

    explicit PixelBalls(const std::filesystem::path& shader_folder);

    /// Whether there are many balls, but neither more nor more pixels than the device can keep.
    bool can_draw(const Picture& picture) const;

    /// Finds what each pixel shows, and lists the other balls. `draws`: commands that are to draw the list, each with
    /// no instances yet. The frame block must be bound.
    void find(const Picture& picture, bool valued, std::span<const NearDraw> draws);

    /// After that: the program for the pixels, in use, for the surface's uniforms; and, with it and with the depth test
    /// on, the pixels.
    const gl::Program& use(bool valued) const;
    void draw() const;

    /// The NearBalls in the list, and the commands in the order given, bound to be drawn by.
    const gl::Buffer& near_balls() const { return near_balls_; }
    const void* bind_draw(std::size_t draw) const;

private:
    gl::Program clear_;
    gl::Program find_;
    gl::Program usual_;
    gl::Program valued_;
    gl::Buffer pixels_;  // as many as the largest picture so far, the same of balls
    gl::Buffer near_balls_;
    gl::Buffer near_draws_;
    gl::VertexArray no_attributes_;
    std::size_t largest_block_ = 0;  // bytes
};

}  // namespace ballpit::view
