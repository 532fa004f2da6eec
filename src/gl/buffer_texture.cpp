#include "gl/buffer_texture.h"

namespace ballpit::gl {

BufferTexture::BufferTexture() {
    GLuint id = 0;
    glGenTextures(1, &id);
    handle_ = Handle<delete_texture>(id);
}

void BufferTexture::bind(GLuint unit, const Buffer& buffer, GLenum format) const {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_BUFFER, handle_.id());
    glTexBuffer(GL_TEXTURE_BUFFER, format, buffer.id());
}

std::size_t BufferTexture::capacity() {
    GLint elements = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &elements);
    return static_cast<std::size_t>(elements);
}

}  // namespace ballpit::gl
