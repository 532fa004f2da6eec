// A square depth picture that shaders compare with: what a light sees.
#pragma once

#include "gl/framebuffer.h"
#include "gl/texture.h"

namespace ballpit::gl {

class DepthMap {
public:
    /// `size` pixels a side. Throws Error when the device cannot have it.
    explicit DepthMap(int size);

    /// Makes it the target of drawing and sets the viewport.
    void bind_target() const;
    /// For a sampler2DShadow: the share of the four nearest pixels that are at least as deep; 1 outside.
    void bind(GLuint unit) const;

private:
    Handle<delete_texture> texture_;
    Handle<delete_framebuffer> framebuffer_;
    int size_;
};

}  // namespace ballpit::gl
