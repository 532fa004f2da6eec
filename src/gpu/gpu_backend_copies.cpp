// What GpuBackend copies: saved states, slots read and written, the history of a few balls.
#include <algorithm>
#include <cassert>

#include "gl/reset.h"
#include "gpu/gpu_backend.h"

namespace ballpit::gpu {

namespace {

// What a checkpoint keeps; everything else follows from it.
constexpr std::array saved_slots = {Slot::positions, Slot::velocities, Slot::compensations, Slot::damping_ratios,
                                    Slot::status};

// Where the order is kept the state is in these: who writes into one of them ends it.
constexpr std::array order_slots = {Slot::positions, Slot::velocities, Slot::keys, Slot::next_positions,
                                    Slot::next_velocities};

struct GpuState final : SavedState {
    using SavedState::SavedState;
    std::size_t bytes() const override {
        std::size_t sum = built_positions.size();
        for (const gl::Buffer& buffer : buffers) {
            sum += buffer.size();
        }
        return sum;
    }

    std::array<gl::Buffer, saved_slots.size()> buffers;
    gl::Buffer built_positions;
};

}  // namespace

std::unique_ptr<SavedState> GpuBackend::save() {
    auto state =
        std::make_unique<GpuState>(static_cast<std::uint32_t>(used_bytes_[physical(Slot::positions)] / sizeof(vec4)));
    const auto copied = [this](Slot slot) {
        const std::size_t bytes = used_bytes_[physical(slot)];
        if (bytes == 0) {
            return gl::Buffer();
        }
        use(slot, Use::copy);
        gl::Buffer copy(slot_name(slot), bytes);
        gl::copy(buffer(slot), copy, bytes);
        return copy;
    };
    std::ranges::transform(saved_slots, state->buffers.begin(), copied);
    state->built_positions = copied(Slot::built_positions);
    return state;
}

void GpuBackend::restore(const SavedState& state, const Schedule& schedule) {
    const auto& saved = dynamic_cast<const GpuState&>(state);
    std::vector<SlotRoom> rooms = rooms_of(schedule);
    for (std::size_t i = 0; i < saved_slots.size(); ++i) {
        if (saved_slots[i] != Slot::compensations) {
            rooms[static_cast<std::size_t>(saved_slots[i])].bytes = saved.buffers[i].size();
        }
    }
    make_room(rooms);
    in_order_ = false;
    in_place_of_ids_ = true;
    const auto fill = [this](Slot slot, const gl::Buffer& bytes) {
        if (bytes.size() != 0 && bytes.size() == used_bytes_[physical(slot)]) {
            use(slot, Use::copy);
            gl::copy(bytes, buffer(slot), bytes.size());
        }
    };
    write(Slot::compensations, Bytes(used_bytes_[physical(Slot::compensations)]));  // where none were saved
    for (std::size_t i = 0; i < saved_slots.size(); ++i) {
        fill(saved_slots[i], saved.buffers[i]);
    }
    if (!schedule.in_place) {
        fill(Slot::next_positions, saved.buffers[0]);  // as load() leaves them
        fill(Slot::next_velocities, saved.buffers[1]);
    }
    compile(schedule);
    forget_grid(schedule);
    fill(Slot::built_positions, saved.built_positions);
}

Bytes GpuBackend::read(Slot slot) {
    use(slot, Use::copy);
    Bytes bytes = buffer(slot).read(used_bytes_[physical(slot)]);
    gl::expect_context();
    return bytes;
}

// By way of another buffer: the device then copies when its turn comes. glBufferSubData, too, has to wait for shaders
// behind a barrier, but a driver (NVIDIA 580.159.04) was seen to let it overtake atomics that were still under way.
void GpuBackend::write(Slot slot, std::span<const std::byte> bytes) {
    assert(bytes.size() <= used_bytes_[physical(slot)]);
    if (!bytes.empty()) {
        if (std::ranges::find(order_slots, slot) != order_slots.end()) {
            leave_order();
        }
        gl::Buffer upload("upload", bytes.size(), GL_STREAM_COPY);
        upload.write(bytes);
        use(slot, Use::copy);
        gl::copy(upload, buffer(slot), bytes.size());
    }
}

void GpuBackend::request(Slot slot) {
    const auto index = static_cast<std::size_t>(slot);
    if (readbacks_[index].under_way()) {
        return;
    }
    use(slot, Use::copy);
    readbacks_[index].request(buffer(slot), used_bytes_[physical(slot)]);
}

std::optional<Bytes> GpuBackend::poll(Slot slot) { return readbacks_[static_cast<std::size_t>(slot)].poll(); }

void GpuBackend::start_history(std::uint32_t entries) {
    history_.start(entries, used_bytes_[physical(Slot::positions)]);
}

void GpuBackend::record_history() {
    use(Slot::positions, Use::copy);
    use(Slot::velocities, Use::copy);
    history_.record(buffer(Slot::positions), buffer(Slot::velocities));
}

}  // namespace ballpit::gpu
