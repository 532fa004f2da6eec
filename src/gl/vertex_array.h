// A vertex array: which buffers feed which attributes.
#pragma once

#include "gl/buffer.h"

namespace ballpit::gl {

inline void delete_vertex_array(GLuint id) { glDeleteVertexArrays(1, &id); }

class VertexArray {
public:
    VertexArray();

    void bind() const { glBindVertexArray(handle_.id()); }
    /// `components` floats at `offset` of each `stride` bytes; divisor 1 advances once an instance.
    void floats(GLuint location, const Buffer& buffer, GLint components, GLsizei stride, std::size_t offset,
                GLuint divisor = 0);
    /// The same for unsigned integers, which reach the shader as integers.
    void uints(GLuint location, const Buffer& buffer, GLint components, GLsizei stride, std::size_t offset,
               GLuint divisor = 0);
    void indices(const Buffer& buffer);

private:
    Handle<delete_vertex_array> handle_;
};

}  // namespace ballpit::gl
