#include "cpu/keep_places.h"

#include <algorithm>

namespace ballpit::cpu {

template <class Real>
void keep_places(std::span<const Vec4<Real>> positions, std::span<Vec4<Real>> built_positions) {
    std::ranges::copy(positions, built_positions.begin());
}

template void keep_places(std::span<const Vec4<float>>, std::span<Vec4<float>>);
template void keep_places(std::span<const Vec4<double>>, std::span<Vec4<double>>);

}  // namespace ballpit::cpu
