#include "cpu/gather.h"

namespace ballpit::cpu {

template <class Real>
void gather(std::span<const Key> keys, std::span<const Vec4<Real>> positions, std::span<const Vec4<Real>> velocities,
            std::span<Vec4<Real>> sorted_positions, std::span<Vec4<Real>> sorted_velocities) {
    for (std::size_t slot = 0; slot < keys.size(); ++slot) {
        if (const std::uint32_t ball = keys[slot].ball_id; ball < positions.size()) {
            sorted_positions[slot] = positions[ball];
            sorted_velocities[slot] = velocities[ball];
        }
    }
}

template void gather(std::span<const Key>, std::span<const Vec4<float>>, std::span<const Vec4<float>>,
                     std::span<Vec4<float>>, std::span<Vec4<float>>);
template void gather(std::span<const Key>, std::span<const Vec4<double>>, std::span<const Vec4<double>>,
                     std::span<Vec4<double>>, std::span<Vec4<double>>);

}  // namespace ballpit::cpu
