#include "gl/texture.h"

#include <cassert>

namespace ballpit::gl {

Texture::Texture(int width, int height, std::span<const unsigned char> pixels) {
    assert(pixels.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    GLuint id = 0;
    glGenTextures(1, &id);
    handle_ = Handle<delete_texture>(id);
    bind(0);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glGenerateMipmap(GL_TEXTURE_2D);
}

}  // namespace ballpit::gl
