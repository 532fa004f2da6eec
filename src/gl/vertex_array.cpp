#include "gl/vertex_array.h"

namespace ballpit::gl {

VertexArray::VertexArray() {
    GLuint id = 0;
    glGenVertexArrays(1, &id);
    handle_ = Handle<delete_vertex_array>(id);
}

void VertexArray::floats(GLuint location, const Buffer& buffer, GLint components, GLsizei stride, std::size_t offset,
                         GLuint divisor) {
    bind();
    buffer.bind(GL_ARRAY_BUFFER);
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, stride, reinterpret_cast<const void*>(offset));
    glVertexAttribDivisor(location, divisor);
}

void VertexArray::uints(GLuint location, const Buffer& buffer, GLint components, GLsizei stride, std::size_t offset,
                        GLuint divisor) {
    bind();
    buffer.bind(GL_ARRAY_BUFFER);
    glEnableVertexAttribArray(location);
    glVertexAttribIPointer(location, components, GL_UNSIGNED_INT, stride, reinterpret_cast<const void*>(offset));
    glVertexAttribDivisor(location, divisor);
}

void VertexArray::indices(const Buffer& buffer) {
    bind();
    buffer.bind(GL_ELEMENT_ARRAY_BUFFER);
}

}  // namespace ballpit::gl
