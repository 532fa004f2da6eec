// What a device has room for. OpenGL 4.3 guarantees a shader eight buffers of 16 MiB each; what a scene asks for beyond
// that is refused before anything changes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/schedule.h"

namespace ballpit {

struct StorageLimits {
    std::uint32_t blocks = std::numeric_limits<std::uint32_t>::max();    // storage blocks of a compute shader
    std::uint32_t bindings = std::numeric_limits<std::uint32_t>::max();  // binding numbers, from 0
    std::size_t block_bytes = std::numeric_limits<std::size_t>::max();   // of one buffer
    std::optional<std::size_t> free_bytes{};                             // of the device's memory, where it tells
};

/// Throws NoRoom where a dispatch wants more buffers, with the option that can be given up, or a buffer more bytes,
/// with the largest count of balls that fits.
void expect_storage(const Schedule& schedule, const StorageLimits& limits);

/// The largest count of balls, up to the schedule's, whose buffers this device has room for.
std::uint32_t most_balls_that_fit(const Schedule& schedule, const StorageLimits& limits);

}  // namespace ballpit
