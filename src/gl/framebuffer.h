// An off-screen picture with colour (sRGB, 8 bit) and depth, to draw where there is no window to look at.
#pragma once

#include <vector>

#include "gl/handle.h"

namespace ballpit::gl {

inline void delete_framebuffer(GLuint id) { glDeleteFramebuffers(1, &id); }
inline void delete_renderbuffer(GLuint id) { glDeleteRenderbuffers(1, &id); }

class Framebuffer {
public:
    /// Throws Error when the device cannot have one of this size.
    Framebuffer(int width, int height);

    /// Makes it the target of drawing and sets the viewport.
    void bind() const;
    /// RGB bytes of the picture, top row first.
    std::vector<unsigned char> pixels() const;
    int width() const { return width_; }
    int height() const { return height_; }

private:
    Handle<delete_framebuffer> framebuffer_;
    Handle<delete_renderbuffer> colour_;
    Handle<delete_renderbuffer> depth_;
    int width_;
    int height_;
};

/// RGB bytes of what is bound for reading (0: the window), top row first.
std::vector<unsigned char> read_pixels(int width, int height);

}  // namespace ballpit::gl
