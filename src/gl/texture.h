// A 2D texture of 8-bit RGBA.
#pragma once

#include <cstddef>
#include <span>

#include "gl/handle.h"

namespace ballpit::gl {

inline void delete_texture(GLuint id) { glDeleteTextures(1, &id); }

class Texture {
public:
    Texture() = default;
    /// `pixels`: width * height * 4 bytes, top row first as image files have it; mipmapped, repeating.
    Texture(int width, int height, std::span<const unsigned char> pixels);

    void bind(GLuint unit) const {
        glActiveTexture(GL_TEXTURE0 + unit);
        glBindTexture(GL_TEXTURE_2D, handle_.id());
    }
    GLuint id() const { return handle_.id(); }

private:
    Handle<delete_texture> handle_;
};

}  // namespace ballpit::gl
