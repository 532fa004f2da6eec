// Hashes of the state, made on the GPU and read late: a ring of results, one dispatch a hash, one small copy a frame.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <vector>

#include "core/backend.h"
#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/readback.h"

namespace ballpit::gpu {

class StateHasher {
public:
    /// The shader is compiled when the first hash is asked for.
    explicit StateHasher(std::filesystem::path shader_folder) : folder_(std::move(shader_folder)) {}

    /// `positions` and `velocities` must be visible to shaders (after a storage barrier).
    void request(std::uint64_t tag, const gl::Buffer& positions, const gl::Buffer& velocities, std::uint32_t balls);

    /// The hashes that have arrived, in the order of asking; never waits.
    std::vector<TaggedHash> take();

private:
    void prepare();
    void start_copy();
    void deliver(const std::vector<std::byte>& ring);

    struct Pending {
        std::uint64_t tag;
        std::uint32_t entry;
    };

    std::filesystem::path folder_;
    gl::Program program_;
    GLint constants_ = -1;
    gl::Buffer ring_;
    gl::Readback readback_;
    std::uint32_t next_entry_ = 0;
    std::deque<Pending> waiting_;  // asked for, oldest first
    std::size_t copied_ = 0;       // of those, how many the copy under way holds
    std::vector<TaggedHash> arrived_;
};

}  // namespace ballpit::gpu
