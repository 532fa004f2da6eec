// Counter-based random numbers: a pure function of (seed, stream, index), so that ball i is the same
// ball whatever the count, and the same on every platform (std:: distributions are not).
#pragma once

#include <cstdint>

namespace ballpit {

/// SplitMix64's output function (Steele, Lea, Flood 2014): a bijection that mixes all 64 bits.
constexpr std::uint64_t mix_bits(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return z ^ (z >> 31);
}

/// Uniform in [0, 1), 53 bits.
constexpr double random_unit(std::uint64_t seed, std::uint64_t stream, std::uint64_t index) {
    constexpr std::uint64_t golden = 0x9E3779B97F4A7C15ull;
    const std::uint64_t bits =
        mix_bits(mix_bits(mix_bits(seed + golden) + (stream + 1) * golden) + (index + 1) * golden);
    return static_cast<double>(bits >> 11) * 0x1.0p-53;
}

}  // namespace ballpit
