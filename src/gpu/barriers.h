// Which glMemoryBarrier a use of a buffer needs. Shader writes to storage buffers become visible to other uses
// only through a barrier with the bit of *that use*; guessing the bits is how stale data gets drawn.
#pragma once

#include <glad/gl.h>

#include <array>
#include <cstddef>

namespace ballpit::gpu {

/// What the next command does with a buffer that a shader may have written.
enum class Use { storage, vertex, texture, copy };

inline constexpr std::array<GLbitfield, 4> use_bits = {GL_SHADER_STORAGE_BARRIER_BIT,
                                                       GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT, GL_TEXTURE_FETCH_BARRIER_BIT,
                                                       GL_BUFFER_UPDATE_BARRIER_BIT};

/// Keeps, for each of `buffer_count` buffers, the uses to which its last shader write is not yet visible, and
/// whether a shader may still be reading it. Pure bookkeeping: it calls no GL.
template <std::size_t buffer_count>
class Barriers {
public:
    /// Bits that glMemoryBarrier needs before the buffer is used so; 0 where nothing is pending.
    GLbitfield before_use(std::size_t buffer, Use use) const {
        return pending_[buffer] & use_bits[static_cast<std::size_t>(use)];
    }

    /// The same before a shader writes it: earlier shader reads must be over, too.
    GLbitfield before_write(std::size_t buffer) const {
        return before_use(buffer, Use::storage) |
               (read_[buffer] ? use_bits[static_cast<std::size_t>(Use::storage)] : 0u);
    }

    /// A barrier with these bits was issued: it covers every buffer.
    void issued(GLbitfield bits) {
        for (GLbitfield& pending : pending_) {
            pending &= ~bits;
        }
        if ((bits & use_bits[static_cast<std::size_t>(Use::storage)]) != 0) {
            read_ = {};
        }
    }

    /// A dispatch that reads or writes the buffer was issued.
    void shader_reads(std::size_t buffer) { read_[buffer] = true; }
    void shader_writes(std::size_t buffer) { pending_[buffer] = use_bits[0] | use_bits[1] | use_bits[2] | use_bits[3]; }

private:
    std::array<GLbitfield, buffer_count> pending_{};
    std::array<bool, buffer_count> read_{};
};

}  // namespace ballpit::gpu
