// Mirror of glsl/bitonic_sort_fused.comp: the passes that stay inside a tile, all at once.
#pragma once

#include <cstdint>
#include <span>

#include "core/layout.h"

namespace ballpit::cpu {

/// What those passes leave: every tile of `tile_size` slots sorted, ascending where bit k_last of its first
/// slot is 0. (All passes up to k_last sort a tile from nothing; the passes j = tile / 2 .. 1 of one k sort a
/// tile that the passes before them made bitonic.)
void bitonic_sort_fused(std::span<Key> keys, std::uint32_t k_last, std::uint32_t tile_size);

}  // namespace ballpit::cpu
