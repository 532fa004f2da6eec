// The one place where stb's code is compiled. Files are opened by image.cpp, so stb needs no stdio; static, so that
// it cannot collide with a shared libstb.
#include "view/stb.h"

#include <limits>

#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wunused-function"
#if !defined(__clang__)
// gcc 16 does not see that memory needs no callbacks.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#endif

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_NO_STDIO
#include <stb_image.h>

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>

namespace ballpit::view::stb {

std::optional<Image> decode(std::span<const unsigned char> bytes, std::string& reason) {
    int channels = 0;
    Image image;
    if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
        reason = "larger than 2 GiB";
        return std::nullopt;
    }
    stbi_uc* pixels = stbi_load_from_memory(bytes.data(), static_cast<int>(bytes.size()), &image.width, &image.height,
                                            &channels, STBI_rgb_alpha);
    if (pixels == nullptr) {
        reason = stbi_failure_reason();
        return std::nullopt;
    }
    image.pixels.assign(pixels,
                        pixels + static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4);
    stbi_image_free(pixels);
    return image;
}

std::vector<char> encode_png(int width, int height, std::span<const unsigned char> rgb) {
    std::vector<char> png;
    const auto append = [](void* context, void* data, int size) {
        const auto* bytes = static_cast<const char*>(data);
        static_cast<std::vector<char>*>(context)->insert(static_cast<std::vector<char>*>(context)->end(), bytes,
                                                         bytes + size);
    };
    stbi_write_png_to_func(append, &png, width, height, 3, rgb.data(), width * 3);
    return png;
}

}  // namespace ballpit::view::stb
