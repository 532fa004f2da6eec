// Which balls others hide: in a pile most of them, and each would cost a CPU that draws as much as one that is seen.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/vector.h"
#include "view/picture.h"

namespace ballpit::view {

/// Of `order` (numbers of balls, nearest first, as nearest_first() has them) those of which a pixel of the picture may
/// be seen, in the same order. What is left out changes no pixel of the simple look, but where balls are pressed into
/// each other so that a nearer one comes later in the order. positions: centre (m), radius (m; negative: in
/// quarantine). Of the picture: where from, and how many pixels.
std::vector<std::uint32_t> without_hidden(std::span<const std::uint32_t> order, std::span<const vec4> positions,
                                          const Picture& picture);

}  // namespace ballpit::view
