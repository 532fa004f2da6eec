// Mirror of glsl/bitonic_sort_strides.comp: up to three passes that reach beyond a tile.
#pragma once

#include <cstdint>
#include <span>

#include "core/layout.h"

namespace ballpit::cpu {

/// The passes (k, j), (k, j / 2), ... one after the other.
void bitonic_sort_strides(std::span<Key> keys, std::uint32_t k, std::uint32_t j, std::uint32_t passes);

}  // namespace ballpit::cpu
