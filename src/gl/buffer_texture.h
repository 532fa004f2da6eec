// A buffer that shaders read by index (OpenGL 3.3 has no storage buffers).
#pragma once

#include "gl/buffer.h"
#include "gl/texture.h"

namespace ballpit::gl {

class BufferTexture {
public:
    BufferTexture();

    /// For a samplerBuffer of the kind that `format` (GL_RGBA32F, GL_RG32UI) asks for. The buffer must outlive its use.
    void bind(GLuint unit, const Buffer& buffer, GLenum format) const;
    /// Elements that the device can read; at least 65536, usually some 10^8.
    static std::size_t capacity();

private:
    Handle<delete_texture> handle_;
};

}  // namespace ballpit::gl
