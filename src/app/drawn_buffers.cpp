#include "app/drawn_buffers.h"

#include "gpu/gpu_backend.h"
#include "view/depth_order.h"
#include "view/hidden_balls.h"

namespace ballpit::app {

const gl::Buffer* DrawnBuffers::get(Backend& backend, Slot slot, gl::Buffer& copy) {
    if (auto* gpu = dynamic_cast<gpu::GpuBackend*>(&backend)) {
        const gl::Buffer& buffer = gpu->buffer_for_drawing(slot);
        return buffer.size() == 0 ? nullptr : &buffer;
    }
    return upload(backend.read(slot), slot_name(slot), copy);  // the mirror's memory: no device to wait for
}

const gl::Buffer* DrawnBuffers::upload(std::span<const std::byte> bytes, std::string_view label, gl::Buffer& copy) {
    if (bytes.empty()) {
        return nullptr;
    }
    if (copy.size() < bytes.size()) {
        copy = gl::Buffer(label, bytes.size(), GL_STREAM_DRAW);
    }
    copy.write(bytes);
    return &copy;
}

void DrawnBuffers::set_order(Backend& backend, view::Picture& picture) {
    const auto positions = read_slot<vec4>(backend, Slot::positions);
    const auto order = view::without_hidden(view::nearest_first(positions, picture.camera), positions, picture);
    upload(std::as_bytes(std::span(order)), "order of balls", order_);
    picture.order = &order_;
    picture.order_count = static_cast<std::uint32_t>(order.size());
}

}  // namespace ballpit::app
