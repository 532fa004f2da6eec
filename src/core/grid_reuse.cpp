#include "core/grid_reuse.h"

#include <bit>
#include <cmath>

namespace ballpit {

double skin(const Grid& grid, double largest_radius) { return grid.cell_width - 2.0 * largest_radius; }

double drift(const Status& status) { return std::sqrt(static_cast<double>(std::bit_cast<float>(status.drift_bits))); }

double cell_factor_for(double drift, double largest_radius) {
    constexpr double reserve = 1.25;
    constexpr double hundred = 100.0;
    return largest_radius > 0.0 ? std::ceil(hundred * (1.0 + reserve * drift / (2.0 * largest_radius))) / hundred : 1.0;
}

}  // namespace ballpit
