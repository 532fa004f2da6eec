// State hash: shows that two runs are the same run, bit for bit. A sum over the words of the state, each mixed
// with its place, so that threads can add up their parts in any order and still get the same number.
#pragma once

#include <cstdint>

namespace ballpit {

/// The finaliser of MurmurHash3 (Appleby, public domain): a bijection of 32 bits.
constexpr std::uint32_t mix_word(std::uint32_t h) {
    h = (h ^ (h >> 16)) * 0x85EBCA6Bu;
    h = (h ^ (h >> 13)) * 0xC2B2AE35u;
    return h ^ (h >> 16);
}

class HashSum {
public:
    /// Adds the word at this place (0 to 2^32 - 2).
    constexpr void add(std::uint32_t word, std::uint32_t place) {
        const std::uint32_t h = mix_word(word + mix_word(place + 1u));
        low_ += h;
        high_ += mix_word(h ^ 0x9E3779B9u);
    }
    constexpr std::uint64_t value() const { return static_cast<std::uint64_t>(high_) << 32 | low_; }

private:
    std::uint32_t low_ = 0;
    std::uint32_t high_ = 0;
};

}  // namespace ballpit
