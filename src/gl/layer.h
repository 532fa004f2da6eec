// A picture with alpha that is drawn once and laid over others as often as wanted.
#pragma once

#include <utility>

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "gl/vertex_array.h"

namespace ballpit::gl {

class Layer {
public:
    /// `program`: a full-screen triangle that takes its colour from texture unit 0, texel by pixel.
    explicit Layer(Program program) : program_(std::move(program)) {}

    /// Makes it the target of drawing, as it was left; `width` x `height` pixels, as all that follows, and empty where
    /// that is another size than before. Throws Error when the device cannot have one of this size.
    void begin(int width, int height);
    /// Between begin() and end(): empties a rectangle of it (pixels from the lower left corner).
    void clear(int x, int y, int width, int height) const;
    /// What was bound before begin() is the target again.
    void end();
    bool holds(int width, int height) const { return width == width_ && height == height_; }

    /// Lays a rectangle of it (pixels from the lower left corner) over the same one of what is bound.
    void lay_over(int x, int y, int width, int height) const;

private:
    void resize(int width, int height);

    Program program_;
    Handle<delete_texture> texture_;
    Handle<delete_framebuffer> framebuffer_;
    VertexArray no_attributes_;
    GLint before_ = 0;
    int width_ = 0;
    int height_ = 0;
};

}  // namespace ballpit::gl
