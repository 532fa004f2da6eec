#include "gl/buffer.h"

#include <cassert>
#include <string>

#include "gl/debug.h"
#include "gl/error.h"

namespace ballpit::gl {

namespace {

// The copy target disturbs no state that drawing or dispatching looks at.
constexpr GLenum neutral = GL_COPY_WRITE_BUFFER;

// Older errors are not this buffer's; a lost context would report one for ever.
constexpr int most_errors = 64;

std::string mebibytes(std::size_t bytes) { return std::to_string((bytes + (1u << 20) - 1) >> 20) + " MiB"; }

}  // namespace

Buffer::Buffer(std::string_view label, std::size_t bytes, GLenum usage) : size_(bytes) {
    GLuint id = 0;
    glGenBuffers(1, &id);
    handle_ = Handle<delete_buffer>(id);
    for (int i = 0; i < most_errors && glGetError() != GL_NO_ERROR; ++i) {
    }
    glBindBuffer(neutral, id);
    glBufferData(neutral, static_cast<GLsizeiptr>(bytes), nullptr, usage);
    if (glGetError() != GL_NO_ERROR) {
        throw Error("the device has no room for buffer '" + std::string(label) + "' of " + mebibytes(bytes));
    }
    label_object(GL_BUFFER, id, label);
}

void Buffer::write(std::span<const std::byte> bytes, std::size_t offset) {
    assert(offset + bytes.size() <= size_);
    if (bytes.empty()) {
        return;
    }
    bind(neutral);
    glBufferSubData(neutral, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes.size()), bytes.data());
}

std::vector<std::byte> Buffer::read(std::size_t count) const {
    assert(count <= size_);
    std::vector<std::byte> bytes(count);
    if (count != 0) {
        bind(neutral);
        glGetBufferSubData(neutral, 0, static_cast<GLsizeiptr>(count), bytes.data());
    }
    return bytes;
}

void copy(const Buffer& from, const Buffer& to, std::size_t bytes, std::size_t offset) {
    assert(bytes <= from.size() && offset + bytes <= to.size());
    from.bind(GL_COPY_READ_BUFFER);
    to.bind(GL_COPY_WRITE_BUFFER);
    glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, static_cast<GLintptr>(offset),
                        static_cast<GLsizeiptr>(bytes));
}

void fill(const Buffer& buffer, std::size_t bytes, std::uint32_t value) {
    assert(bytes <= buffer.size() && bytes % sizeof(value) == 0);
    if (bytes != 0) {
        buffer.bind(GL_COPY_WRITE_BUFFER);
        glClearBufferSubData(GL_COPY_WRITE_BUFFER, GL_R32UI, 0, static_cast<GLsizeiptr>(bytes), GL_RED_INTEGER,
                             GL_UNSIGNED_INT, &value);
    }
}

}  // namespace ballpit::gl
