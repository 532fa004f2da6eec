#include "support/gas.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ballpit::test {

namespace {

using std::numbers::pi;

// Balls in the order of x, so that a ball meets only those within a diameter.
void add_pairs(const BallState& state, double stiffness, GasSums& sums) {
    std::vector<std::size_t> order(state.count());
    float largest = 0.0f;
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = i;
        largest = std::max(largest, state.positions[i].w);
    }
    std::ranges::sort(order, {}, [&](std::size_t i) { return state.positions[i].x; });
    for (std::size_t i = 0; i < order.size(); ++i) {
        const vec4& a = state.positions[order[i]];
        for (std::size_t j = i + 1; j < order.size(); ++j) {
            const vec4& b = state.positions[order[j]];
            if (b.x - a.x > a.w + largest) {
                break;
            }
            const double reach = static_cast<double>(a.w) + static_cast<double>(b.w);
            const double distance = glm::length(dvec3(a) - dvec3(b));
            sums.pair_virial += distance * stiffness * std::max(reach - distance, 0.0);
        }
    }
}

void add_walls(const BallState& state, const Box& box, double stiffness, GasSums& sums) {
    for (const vec4& p : state.positions) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto x = static_cast<double>(p[axis]);
            const double low = std::max(static_cast<double>(p.w) - (x - box.lower[axis]), 0.0) * stiffness;
            const double high = std::max(static_cast<double>(p.w) - (box.upper[axis] - x), 0.0) * stiffness;
            sums.wall_force += low + high;
            sums.wall_virial += (low + high) * std::abs(x);
            sums.floor_force += axis == 2 ? low : 0.0;
        }
    }
}

// Share of balls slower than v, where the mean square speed is 3 s^2.
double maxwell_share(double v, double s) {
    const double u = v / s;
    return std::erf(u / std::numbers::sqrt2) - std::sqrt(2.0 / pi) * u * std::exp(-0.5 * u * u);
}

}  // namespace

GasSums gas_sums(Simulation& simulation, bool springs) {
    const BallState state = simulation.raw_state();
    GasSums sums;
    for (const vec4& v : state.velocities) {
        sums.kinetic += 0.5 * static_cast<double>(v.w) * glm::dot(dvec3(v), dvec3(v));
    }
    if (springs) {
        add_pairs(state, simulation.settings().stiffness, sums);
        add_walls(state, simulation.box(), simulation.settings().stiffness, sums);
    }
    return sums;
}

int balls_within(Simulation& simulation, double half_extent) {
    const BallState state = simulation.raw_state();
    return static_cast<int>(std::ranges::count_if(state.positions, [&](const vec4& p) {
        return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) < static_cast<float>(half_extent);
    }));
}

std::vector<double> speeds(Simulation& simulation) {
    std::vector<double> result;
    for (const vec4& v : simulation.raw_state().velocities) {
        result.push_back(glm::length(dvec3(v)));
    }
    return result;
}

std::vector<double> heights(Simulation& simulation) {
    std::vector<double> result;
    for (const vec4& p : simulation.raw_state().positions) {
        result.push_back(static_cast<double>(p.z) - simulation.box().lower.z);
    }
    return result;
}

double maxwell_chi_squared(const std::vector<double>& speeds, int bins) {
    double square = 0.0;
    for (const double v : speeds) {
        square += v * v / static_cast<double>(speeds.size());
    }
    const double s = std::sqrt(square / 3.0);
    std::vector<double> counts(static_cast<std::size_t>(bins), 0.0);
    for (const double v : speeds) {
        const auto bin = static_cast<int>(maxwell_share(v, s) * bins);
        counts[static_cast<std::size_t>(std::min(bin, bins - 1))] += 1.0;
    }
    const double expected = static_cast<double>(speeds.size()) / bins;
    double sum = 0.0;
    for (const double count : counts) {
        sum += (count - expected) * (count - expected) / expected;
    }
    return sum / (bins - 2);  // the number and the mean square are given
}

}  // namespace ballpit::test
