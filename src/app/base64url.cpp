#include "app/base64url.h"

#include <cstdint>

namespace ballpit::app {

namespace {

constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
constexpr unsigned letter_bits = 6;
constexpr unsigned byte_bits = 8;

}  // namespace

std::string base64url(const std::vector<unsigned char>& bytes) {
    std::string text;
    text.reserve((bytes.size() * byte_bits + letter_bits - 1) / letter_bits);
    std::uint32_t waiting = 0;
    unsigned bits = 0;
    for (const unsigned char byte : bytes) {
        waiting = (waiting << byte_bits | byte) & 0xFFFFu;
        for (bits += byte_bits; bits >= letter_bits; bits -= letter_bits) {
            text += letters[waiting >> (bits - letter_bits) & 63u];
        }
    }
    if (bits > 0) {
        text += letters[waiting << (letter_bits - bits) & 63u];
    }
    return text;
}

std::optional<std::vector<unsigned char>> parse_base64url(std::string_view text) {
    std::vector<unsigned char> bytes;
    bytes.reserve(text.size() * letter_bits / byte_bits);
    std::uint32_t waiting = 0;
    unsigned bits = 0;
    for (const char letter : text) {
        const std::size_t value = letters.find(letter);
        if (value == std::string_view::npos) {
            return std::nullopt;
        }
        waiting = (waiting << letter_bits | static_cast<std::uint32_t>(value)) & 0xFFFFu;
        bits += letter_bits;
        if (bits >= byte_bits) {
            bits -= byte_bits;
            bytes.push_back(static_cast<unsigned char>(waiting >> bits & 0xFFu));
        }
    }
    const bool whole = bits < letter_bits && (waiting & ((1u << bits) - 1u)) == 0;
    return whole ? std::optional(std::move(bytes)) : std::nullopt;
}

}  // namespace ballpit::app
