#include "core/dispatch_slices.h"

#include <algorithm>
#include <cmath>

namespace ballpit {

double cells_looked_at(const Program& program) {
    switch (program.shader) {
        case Shader::order_keys:
            return 1.0;
        case Shader::count_missed:
            return cells_around;
        case Shader::collide:
            return program.features.has(Feature::contact) ? cells_around : 0.0;
        default:
            return 0.0;
    }
}

double local_density(std::span<const vec4> positions, const Grid& grid) {
    std::vector<std::uint32_t> balls(grid.cell_count(), 0);
    double met = 0.0;  // by all balls in their own cells, themselves included
    for (const vec4& position : positions) {
        std::uint32_t& count = balls[cell_id(cell_of(dvec3(position), grid), grid)];
        met += 2.0 * count + 1.0;
        ++count;
    }
    const double volume = grid.cell_width * grid.cell_width * grid.cell_width;
    return positions.empty() ? 0.0 : met / static_cast<double>(positions.size()) / volume;
}

double pairs_of(const Schedule& schedule, double density, double cells) {
    const auto balls = static_cast<double>(schedule.ball_count);
    if (schedule.features.has(Feature::brute_force)) {
        return balls * balls;
    }
    const double width = schedule.grid.cell_width;
    return balls * std::min(balls, cells * density * width * width * width);
}

std::vector<Slice> slices_of(std::uint32_t ball_count, std::uint32_t count) {
    const std::uint32_t groups = (ball_count + (GROUP_SIZE - 1)) / GROUP_SIZE;
    // A folded dispatch would have threads for balls of the next slice, too.
    const std::uint32_t a_slice = std::min((groups + count - 1) / count, widest_dispatch);
    std::vector<Slice> slices;
    for (std::uint32_t first = 0; first < groups; first += a_slice) {
        const std::uint32_t width = std::min(a_slice, groups - first);
        slices.push_back({first * GROUP_SIZE, groups_for(width * GROUP_SIZE, GROUP_SIZE)});
    }
    return slices;
}

}  // namespace ballpit
