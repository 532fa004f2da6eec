// How many buffers a device lets one shader have. OpenGL 4.3 guarantees eight; a permutation may want one more.
#pragma once

#include <cstdint>
#include <limits>

#include "core/schedule.h"

namespace ballpit {

struct StorageLimits {
    std::uint32_t blocks = std::numeric_limits<std::uint32_t>::max();    // storage blocks of a compute shader
    std::uint32_t bindings = std::numeric_limits<std::uint32_t>::max();  // binding numbers, from 0
};

/// Throws DeviceError where a dispatch wants more, with the law that can be switched off.
void expect_storage(const Schedule& schedule, const StorageLimits& limits);

}  // namespace ballpit
