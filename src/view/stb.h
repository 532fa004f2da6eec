// stb_image and stb_image_write, in the two forms that image.cpp needs.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "view/model.h"

namespace ballpit::view::stb {

/// Empty, with stb's reason, when these bytes are no picture that it reads.
std::optional<Image> decode(std::span<const unsigned char> bytes, std::string& reason);

/// Empty when out of memory.
std::vector<char> encode_png(int width, int height, std::span<const unsigned char> rgb);

}  // namespace ballpit::view::stb
