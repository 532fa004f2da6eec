#include "cpu/count_missed.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/quarantine.h"
#include "cpu/neighbours.h"

namespace ballpit::cpu {

namespace {

template <class Real>
Real length_squared(const Vec3<Real>& a) {
    return a.x * a.x + a.y * a.y + a.z * a.z;  // in the shader's order of additions
}

bool are_adjacent(const uvec3& a, const uvec3& b) {
    return glm::all(glm::lessThanEqual(glm::abs(glm::ivec3(a) - glm::ivec3(b)), glm::ivec3(1)));
}

}  // namespace

template <class Real>
void count_missed(const SubstepParams<Real>& params, Features features, std::span<const Vec4<Real>> positions,
                  std::span<const Vec4<Real>> built_positions, std::span<const Key> keys,
                  std::span<const CellRange> cell_ranges, Status& status) {
    const bool unequal = features.has(Feature::unequal_radii);
    const auto radius_of = [&](std::uint32_t id) { return unequal ? positions[id].w : params.radius; };
    for (std::uint32_t id = 0; id < params.ball_count; ++id) {
        const Vec3<Real> position(positions[id]);
        const auto way_squared = static_cast<float>(length_squared<Real>(position - Vec3<Real>(built_positions[id])));
        status.drift_bits =
            std::max(status.drift_bits, std::bit_cast<std::uint32_t>(std::isnan(way_squared) ? 0.0f : way_squared));
        if (in_quarantine(positions[id])) {
            continue;  // touches nobody
        }
        const uvec3 cell = cell_coordinates(params, position);
        const auto meet = [&](std::uint32_t other) {
            const Real reach = radius_of(id) + radius_of(other);
            if (!in_quarantine(positions[other]) &&
                length_squared<Real>(position - Vec3<Real>(positions[other])) < reach * reach &&
                !are_adjacent(cell, cell_coordinates(params, Vec3<Real>(built_positions[other])))) {
                status.bits |= STATUS_MISSED;
                ++status.missed;
            }
        };
        for_each_in_cells_around<Real>(params, keys, cell_ranges, position, id, meet);
    }
}

template void count_missed(const SubstepParams<float>&, Features, std::span<const Vec4<float>>,
                           std::span<const Vec4<float>>, std::span<const Key>, std::span<const CellRange>, Status&);
template void count_missed(const SubstepParams<double>&, Features, std::span<const Vec4<double>>,
                           std::span<const Vec4<double>>, std::span<const Key>, std::span<const CellRange>, Status&);

}  // namespace ballpit::cpu
