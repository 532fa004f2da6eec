// Mirror of glsl/bitonic_sort.comp: one pass of the bitonic network.
#pragma once

#include <span>

#include "core/layout.h"

namespace ballpit::cpu {

/// Compares and exchanges every pair of slots (i, i XOR j), ascending where bit k of i is 0.
/// keys.size() is a power of two; k and j are powers of two with j < k <= keys.size().
void bitonic_sort(std::span<Key> keys, std::uint32_t k, std::uint32_t j);

}  // namespace ballpit::cpu
