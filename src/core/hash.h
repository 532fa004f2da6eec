// State hash: shows that two runs are the same run, bit for bit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace ballpit {

/// FNV-1a, 64 bit (Fowler, Noll, Vo), over the bytes in order.
inline std::uint64_t hash_bytes(std::span<const std::byte> bytes, std::uint64_t hash = 0xCBF29CE484222325ull) {
    for (const std::byte byte : bytes) {
        hash = (hash ^ static_cast<std::uint64_t>(byte)) * 0x100000001B3ull;
    }
    return hash;
}

}  // namespace ballpit
