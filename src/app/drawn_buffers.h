// The buffers that drawing reads: the GPU backend's own, or, for the CPU mirror, a copy uploaded for this frame.
#pragma once

#include "core/backend.h"
#include "gl/buffer.h"

namespace ballpit::app {

class DrawnBuffers {
public:
    /// Ready to be read as vertex attributes until the backend runs again; null where there are no balls or no cells.
    const gl::Buffer* positions(Backend& backend) { return get(backend, Slot::positions, positions_); }
    const gl::Buffer* velocities(Backend& backend) { return get(backend, Slot::velocities, velocities_); }
    const gl::Buffer* cell_ranges(Backend& backend) { return get(backend, Slot::cell_ranges, cell_ranges_); }

private:
    static const gl::Buffer* get(Backend& backend, Slot slot, gl::Buffer& copy);

    gl::Buffer positions_;
    gl::Buffer velocities_;
    gl::Buffer cell_ranges_;
};

}  // namespace ballpit::app
