// A copy of a buffer for the CPU that nobody waits for: copied on the device, fenced, mapped when it is done.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "gl/buffer.h"

namespace ballpit::gl {

class Readback {
public:
    Readback() = default;
    Readback(Readback&& other) noexcept;
    Readback& operator=(Readback&& other) noexcept;
    ~Readback();

    bool under_way() const { return fence_ != nullptr; }
    /// Starts a copy of the first `bytes` as the GL commands so far leave them.
    void request(const Buffer& source, std::size_t bytes);
    /// The bytes, once: empty while the device is still at it or nothing was asked for.
    std::optional<std::vector<std::byte>> poll();

private:
    Buffer staging_;
    std::size_t size_ = 0;
    GLsync fence_ = nullptr;
};

}  // namespace ballpit::gl
