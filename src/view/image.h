// Pictures to and from files.
#pragma once

#include <filesystem>
#include <span>

#include "view/model.h"

namespace ballpit::view {

/// Any format that stb_image reads. Throws InputError with file and reason.
Image load_image(const std::filesystem::path& path);

/// `rgb`: width * height * 3 bytes, top row first. Written beside its place and then renamed: a file of that name
/// is either whole or was never touched. Throws InputError when it cannot be written.
void save_png(const std::filesystem::path& path, int width, int height, std::span<const unsigned char> rgb);

}  // namespace ballpit::view
