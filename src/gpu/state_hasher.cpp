#include "gpu/state_hasher.h"

#include <array>
#include <utility>

#include "core/schedule.h"
#include "gl/debug.h"

namespace ballpit::gpu {

void StateHasher::prepare() {
    if (ring_.size() != 0) {
        return;
    }
    const std::array stages = {gl::ShaderStage{GL_COMPUTE_SHADER, gl::load_shader(folder_, "hash_state.comp")}};
    program_ = gl::Program(stages);
    constants_ = program_.uniform("dispatch_constants");
    ring_ = gl::Buffer("hashes", HASH_RING_SIZE * sizeof(layout::HashSum));
}

void StateHasher::request(std::uint64_t tag, const gl::Buffer& positions, const gl::Buffer& velocities,
                          std::uint32_t balls) {
    prepare();
    if (waiting_.size() == HASH_RING_SIZE) {  // nobody took any: the oldest entry would be overwritten unread
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        copied_ = waiting_.size();
        deliver(ring_.read());
        readback_ = {};
    }
    const gl::DebugGroup group("hash_state");
    const layout::HashSum zero{0, 0};
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    ring_.write(std::as_bytes(std::span(&zero, 1)), next_entry_ * sizeof(layout::HashSum));
    if (balls > 0) {
        program_.use();
        const std::array<GLuint, 4> constants = {next_entry_, balls, 0, 0};
        glUniform4uiv(constants_, 1, constants.data());
        positions.bind_base(GL_SHADER_STORAGE_BUFFER, SLOT_POSITIONS);
        velocities.bind_base(GL_SHADER_STORAGE_BUFFER, SLOT_VELOCITIES);
        ring_.bind_base(GL_SHADER_STORAGE_BUFFER, BINDING_HASHES);
        const Groups groups = groups_for(balls, GROUP_SIZE);
        glDispatchCompute(groups.x, groups.y, 1);
    }
    waiting_.push_back({tag, next_entry_});
    next_entry_ = (next_entry_ + 1) % HASH_RING_SIZE;
}

void StateHasher::start_copy() {
    if (!readback_.under_way() && !waiting_.empty()) {
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        readback_.request(ring_, ring_.size());
        copied_ = waiting_.size();
    }
}

void StateHasher::deliver(const std::vector<std::byte>& ring) {
    const auto sums = typed<layout::HashSum>(ring);
    for (; copied_ > 0; --copied_) {
        const layout::HashSum& sum = sums[waiting_.front().entry];
        arrived_.push_back({waiting_.front().tag, static_cast<std::uint64_t>(sum.high) << 32 | sum.low});
        waiting_.pop_front();
    }
}

std::vector<TaggedHash> StateHasher::take() {
    if (const auto ring = readback_.poll()) {
        deliver(*ring);
    }
    start_copy();
    return std::exchange(arrived_, {});
}

}  // namespace ballpit::gpu
