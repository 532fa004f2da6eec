#include "gl/readback.h"

#include <cstring>
#include <utility>

#include "gl/reset.h"

namespace ballpit::gl {

Readback::Readback(Readback&& other) noexcept
    : staging_(std::move(other.staging_)), size_(other.size_), fence_(std::exchange(other.fence_, nullptr)) {}

Readback& Readback::operator=(Readback&& other) noexcept {
    std::swap(staging_, other.staging_);
    std::swap(size_, other.size_);
    std::swap(fence_, other.fence_);
    return *this;
}

Readback::~Readback() {
    if (fence_ != nullptr) {
        glDeleteSync(fence_);
    }
}

void Readback::request(const Buffer& source, std::size_t bytes) {
    if (under_way() || bytes == 0) {
        return;
    }
    if (staging_.size() < bytes) {
        staging_ = Buffer("readback", bytes, GL_STREAM_READ);
    }
    size_ = bytes;
    source.bind(GL_COPY_READ_BUFFER);
    staging_.bind(GL_COPY_WRITE_BUFFER);
    glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, static_cast<GLsizeiptr>(size_));
    fence_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

std::optional<std::vector<std::byte>> Readback::poll() {
    if (fence_ == nullptr) {
        return std::nullopt;
    }
    const GLenum state = glClientWaitSync(fence_, GL_SYNC_FLUSH_COMMANDS_BIT, 0);
    if (state != GL_ALREADY_SIGNALED && state != GL_CONDITION_SATISFIED) {
        expect_context();  // else who waits for it would wait for ever
        return std::nullopt;
    }
    glDeleteSync(std::exchange(fence_, nullptr));
    std::vector<std::byte> bytes(size_);
    staging_.bind(GL_COPY_READ_BUFFER);
    const void* mapped = glMapBufferRange(GL_COPY_READ_BUFFER, 0, static_cast<GLsizeiptr>(size_), GL_MAP_READ_BIT);
    if (mapped == nullptr) {
        expect_context();
        return std::nullopt;
    }
    std::memcpy(bytes.data(), mapped, size_);
    glUnmapBuffer(GL_COPY_READ_BUFFER);
    return bytes;
}

}  // namespace ballpit::gl
