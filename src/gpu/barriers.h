// The bits of glMemoryBarrier for the uses of core/hazards.h.
#pragma once

#include <glad/gl.h>

#include "core/hazards.h"

namespace ballpit::gpu {

inline constexpr std::array<GLbitfield, use_count> use_bits = {
    GL_SHADER_STORAGE_BARRIER_BIT, GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT, GL_TEXTURE_FETCH_BARRIER_BIT,
    GL_BUFFER_UPDATE_BARRIER_BIT};

constexpr GLbitfield barrier_bits(Uses uses) {
    GLbitfield bits = 0;
    for (std::size_t i = 0; i < use_count; ++i) {
        bits |= (uses >> i & 1u) != 0 ? use_bits[i] : 0u;
    }
    return bits;
}

}  // namespace ballpit::gpu
