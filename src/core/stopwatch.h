// How long something took, by a clock that never goes back.
#pragma once

#include <chrono>

namespace ballpit {

/// Since `start`, a steady_clock::now().
inline double milliseconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace ballpit
