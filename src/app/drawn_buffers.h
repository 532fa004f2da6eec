// The buffers that drawing reads: the GPU backend's own, or, for the CPU mirror, a copy uploaded for this frame.
#pragma once

#include <span>
#include <string_view>

#include "core/backend.h"
#include "gl/buffer.h"
#include "view/picture.h"

namespace ballpit::app {

class DrawnBuffers {
public:
    /// Ready to be read as vertex attributes until the backend runs again; null where there are no balls or no cells.
    const gl::Buffer* positions(Backend& backend) { return get(backend, Slot::positions, positions_); }
    const gl::Buffer* velocities(Backend& backend) { return get(backend, Slot::velocities, velocities_); }
    const gl::Buffer* cell_ranges(Backend& backend) { return get(backend, Slot::cell_ranges, cell_ranges_); }

    /// Gives a picture whose camera and place are set the balls that can be seen in it, in the order in which they
    /// hide most of what is drawn after them. Reads the positions: not for a device that would have to be waited for.
    void set_order(Backend& backend, view::Picture& picture);

private:
    static const gl::Buffer* get(Backend& backend, Slot slot, gl::Buffer& copy);
    static const gl::Buffer* upload(std::span<const std::byte> bytes, std::string_view label, gl::Buffer& copy);

    gl::Buffer positions_;
    gl::Buffer velocities_;
    gl::Buffer cell_ranges_;
    gl::Buffer order_;
};

}  // namespace ballpit::app
