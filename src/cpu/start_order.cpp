#include "cpu/start_order.h"

#include <algorithm>

namespace ballpit::cpu {

template <class Real>
void start_order(std::span<const Vec4<Real>> positions, std::span<const Vec4<Real>> velocities,
                 std::span<Vec4<Real>> next_positions, std::span<Vec4<Real>> next_velocities, std::span<Key> keys) {
    std::ranges::copy(positions, next_positions.begin());
    std::ranges::copy(velocities, next_velocities.begin());
    for (std::uint32_t ball = 0; ball < positions.size(); ++ball) {
        keys[ball] = {SENTINEL, ball};
    }
}

template void start_order(std::span<const Vec4<float>>, std::span<const Vec4<float>>, std::span<Vec4<float>>,
                          std::span<Vec4<float>>, std::span<Key>);
template void start_order(std::span<const Vec4<double>>, std::span<const Vec4<double>>, std::span<Vec4<double>>,
                          std::span<Vec4<double>>, std::span<Key>);

}  // namespace ballpit::cpu
