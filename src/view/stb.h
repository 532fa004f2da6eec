// stb_image and stb_image_write, in the forms that image.cpp needs; and the zlib format that both carry for PNG.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "view/model.h"

namespace ballpit::view::stb {

/// Empty, with stb's reason, when these bytes are no picture that it reads.
std::optional<Image> decode(std::span<const unsigned char> bytes, std::string& reason);

/// Empty when out of memory.
std::vector<char> encode_png(int width, int height, std::span<const unsigned char> rgb);

/// zlib format (RFC 1950). Empty when out of memory.
std::vector<unsigned char> deflate(std::string_view bytes);

/// Empty when these bytes are not zlib's, are damaged (their checksum tells), or would give more than `most` bytes.
std::optional<std::string> inflate(std::span<const unsigned char> bytes, std::size_t most);

}  // namespace ballpit::view::stb
