#include "measure/sweep_points.h"

#include <array>

namespace ballpit::measure {

namespace {

constexpr std::uint32_t handful = 64;
constexpr std::uint32_t usual_reuse = 8;  // substeps that use one grid
constexpr std::array teaching_integrators = {Integrator::leapfrog, Integrator::symplectic_euler,
                                             Integrator::velocity_verlet, Integrator::historical};

constexpr std::array usual_ladder = {1u, 2u, 3u, 4u, 6u, 8u, 12u, 16u, 24u, 32u, 48u, 64u, 96u, 128u};
constexpr std::array long_ladder = {256u, 512u, 1024u, 4096u, 16384u, 65536u};

std::vector<std::uint32_t> ladder(std::uint32_t balls) {
    std::vector<std::uint32_t> substeps(usual_ladder.begin(), usual_ladder.end());
    if (balls <= handful) {
        substeps.insert(substeps.end(), long_ladder.begin(), long_ladder.end());
    }
    return substeps;
}

template <class T>
std::vector<T> or_else(const std::vector<T>& given, T otherwise) {
    return given.empty() ? std::vector<T>{otherwise} : given;
}

std::vector<SweepPoint> product(const SweepLists& lists) {
    std::vector<SweepPoint> points;
    for (const Integrator integrator : lists.integrators) {
        for (const bool compensated : lists.compensated) {
            for (const std::uint32_t reuse : lists.grid_reuse) {
                for (const std::uint32_t substeps : lists.substeps) {
                    points.push_back({integrator, substeps, compensated, reuse});
                }
            }
        }
    }
    return points;
}

}  // namespace

std::vector<SweepPoint> sweep_points(const Settings& settings, const SweepLists& lists) {
    const auto substeps = lists.substeps.empty() ? ladder(settings.balls) : lists.substeps;
    if (!lists.integrators.empty() || !lists.compensated.empty() || !lists.grid_reuse.empty()) {
        return product({or_else(lists.integrators, settings.integrator), substeps,
                        or_else(lists.compensated, settings.laws.compensated),
                        or_else(lists.grid_reuse, settings.grid_reuse)});
    }
    std::vector<SweepPoint> points =
        product({{teaching_integrators.begin(), teaching_integrators.end()}, substeps, {false}, {1}});
    const auto compensated = product({{Integrator::leapfrog}, substeps, {true}, {1}});
    points.insert(points.end(), compensated.begin(), compensated.end());
    if (settings.laws.contact && settings.neighbours == NeighbourSearch::grid) {
        for (const std::uint32_t n : substeps) {
            if (n >= usual_reuse) {
                points.push_back({Integrator::leapfrog, n, false, usual_reuse});
            }
        }
    }
    return points;
}

}  // namespace ballpit::measure
