#include "gpu/state_history.h"

#include <cassert>

#include "core/error.h"
#include "gl/error.h"

namespace ballpit::gpu {

void StateHistory::start(std::uint32_t entries, std::size_t state_bytes) {
    *this = StateHistory();
    state_bytes_ = state_bytes;
    if (entries == 0 || state_bytes == 0) {
        return;
    }
    try {
        buffer_ = gl::Buffer("history", std::size_t{2} * entries * state_bytes);
    } catch (const gl::Error& error) {
        throw DeviceError(error.what());
    }
}

void StateHistory::record(const gl::Buffer& positions, const gl::Buffer& velocities) {
    if (state_bytes_ == 0) {
        return;  // no balls
    }
    assert(used_ + 2 * state_bytes_ <= buffer_.size());
    gl::copy(positions, buffer_, state_bytes_, used_);
    gl::copy(velocities, buffer_, state_bytes_, used_ + state_bytes_);
    used_ += 2 * state_bytes_;
}

void StateHistory::request() {
    if (!readback_.under_way()) {
        readback_.request(buffer_, used_);
        used_ = 0;
    }
}

}  // namespace ballpit::gpu
