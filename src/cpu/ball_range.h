// Some of the balls, by id: what one thread looks after.
#pragma once

#include <cstdint>

namespace ballpit::cpu {

struct BallRange {
    std::uint32_t first = 0;
    std::uint32_t end = 0;  // one past the last
};

}  // namespace ballpit::cpu
