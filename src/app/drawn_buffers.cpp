#include "app/drawn_buffers.h"

#include "gpu/gpu_backend.h"

namespace ballpit::app {

const gl::Buffer* DrawnBuffers::get(Backend& backend, Slot slot, gl::Buffer& copy) {
    if (auto* gpu = dynamic_cast<gpu::GpuBackend*>(&backend)) {
        const gl::Buffer& buffer = gpu->buffer_for_drawing(slot);
        return buffer.size() == 0 ? nullptr : &buffer;
    }
    const Bytes bytes = backend.read(slot);  // the mirror's memory: no device to wait for
    if (bytes.empty()) {
        return nullptr;
    }
    if (copy.size() < bytes.size()) {
        copy = gl::Buffer(slot_name(slot), bytes.size(), GL_STREAM_DRAW);
    }
    copy.write(bytes);
    return &copy;
}

}  // namespace ballpit::app
