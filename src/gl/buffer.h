// A buffer of fixed size on the device.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "gl/handle.h"

namespace ballpit::gl {

inline void delete_buffer(GLuint id) { glDeleteBuffers(1, &id); }

class Buffer {
public:
    /// An empty buffer: size 0, no GL object.
    Buffer() = default;
    /// `bytes` of undefined content. Throws Error (with both numbers) beyond the device's limit or memory.
    Buffer(std::string_view label, std::size_t bytes, GLenum usage = GL_DYNAMIC_COPY);

    GLuint id() const { return handle_.id(); }
    std::size_t size() const { return size_; }

    /// Copies to and from the start of the buffer, or `offset`; reading waits for the device.
    void write(std::span<const std::byte> bytes, std::size_t offset = 0);
    std::vector<std::byte> read() const { return read(size_); }
    std::vector<std::byte> read(std::size_t count) const;  // the first `count` bytes

    void bind(GLenum target) const { glBindBuffer(target, id()); }
    void bind_base(GLenum target, GLuint index) const { glBindBufferBase(target, index, id()); }

private:
    Handle<delete_buffer> handle_;
    std::size_t size_ = 0;
};

/// Copies the first `bytes` on the device, to the start or to `offset`.
/// Sets each of the first `bytes` / 4 words. Slow on some devices (tens of GB/s): not for every substep.
void fill(const Buffer& buffer, std::size_t bytes, std::uint32_t value);
void copy(const Buffer& from, const Buffer& to, std::size_t bytes, std::size_t offset = 0);

}  // namespace ballpit::gl
