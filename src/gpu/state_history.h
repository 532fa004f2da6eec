// Copies of a small state, one after each substep, that stay on the device until they are asked for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/backend.h"
#include "gl/buffer.h"
#include "gl/readback.h"

namespace ballpit::gpu {

class StateHistory {
public:
    /// Room for `entries` states of `state_bytes` in each of the two buffers; 0: none. Throws DeviceError where the
    /// device has no room.
    void start(std::uint32_t entries, std::size_t state_bytes);
    /// Copies both to the next place. What shaders wrote to them must be visible to copies.
    void record(const gl::Buffer& positions, const gl::Buffer& velocities);
    void request();
    std::optional<Bytes> poll() { return readback_.poll(); }

private:
    gl::Buffer buffer_;
    gl::Readback readback_;
    std::size_t state_bytes_ = 0;
    std::size_t used_ = 0;  // bytes
};

}  // namespace ballpit::gpu
