// The one place where stb's code is compiled. Files are opened by image.cpp, so stb needs no stdio; static, so that
// it cannot collide with a shared libstb.
#include "view/stb.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>

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

namespace {

constexpr std::size_t checksum_bytes = 4;
constexpr int best_compression = 9;

// RFC 1950, 8.2.
std::uint32_t adler32(std::string_view bytes) {
    constexpr std::uint32_t largest_prime = 65521;
    std::uint32_t sum = 1;
    std::uint32_t sum_of_sums = 0;
    for (const char byte : bytes) {
        sum = (sum + static_cast<unsigned char>(byte)) % largest_prime;
        sum_of_sums = (sum_of_sums + sum) % largest_prime;
    }
    return sum_of_sums << 16 | sum;
}

std::uint32_t big_endian(std::span<const unsigned char> bytes) {
    std::uint32_t number = 0;
    for (const unsigned char byte : bytes) {
        number = number << 8 | byte;
    }
    return number;
}

}  // namespace

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

std::vector<unsigned char> deflate(std::string_view bytes) {
    std::string copy(bytes);  // stb asks for bytes that it might change
    int size = 0;
    const std::unique_ptr<unsigned char, decltype(&std::free)> packed(
        stbi_zlib_compress(reinterpret_cast<unsigned char*>(copy.data()), static_cast<int>(copy.size()), &size,
                           best_compression),
        &std::free);
    return packed ? std::vector<unsigned char>(packed.get(), packed.get() + size) : std::vector<unsigned char>();
}

// stb would grow its room for as long as the bytes ask for more: it gets a room that has an end. It does not look at
// the checksum either.
std::optional<std::string> inflate(std::span<const unsigned char> bytes, std::size_t most) {
    if (bytes.size() <= checksum_bytes || bytes.size() > most) {
        return std::nullopt;
    }
    for (std::size_t room = std::min(most, 16 * bytes.size());; room = std::min(most, 4 * room)) {
        std::string text(room, '\0');
        const int size =
            stbi_zlib_decode_buffer(text.data(), static_cast<int>(room), reinterpret_cast<const char*>(bytes.data()),
                                    static_cast<int>(bytes.size()));
        if (size >= 0) {
            text.resize(static_cast<std::size_t>(size));
            const bool intact = adler32(text) == big_endian(bytes.last(checksum_bytes));
            return intact ? std::optional(std::move(text)) : std::nullopt;
        }
        if (room == most) {
            return std::nullopt;
        }
    }
}

}  // namespace ballpit::view::stb
