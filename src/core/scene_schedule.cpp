#include "core/scene_schedule.h"

#include <algorithm>
#include <set>

namespace ballpit {

namespace {

Schedule first_schedule(const Scene& scene, const World& world) {
    const WallShift walls = scene.resume ? scene.resume->walls : WallShift{};
    return scene_schedule(scene.settings, world.box, walls, largest_radius(world.balls), variety_of(world.balls),
                          scene.settings.balls);
}

// The balls that are listed, and two of the fill, which differ wherever it lets them.
World sample_of(const Scene& scene) {
    const std::size_t enough = scene.balls.size() + 2;
    const auto count = static_cast<std::uint32_t>(std::min<std::size_t>(scene.settings.balls, enough));
    return make_world(scene, count, 0);
}

}  // namespace

// The grid covers the box of the scene and the one that is wanted, wherever the walls are between the two: the order of
// the cells, and with it every bit, must not depend on how a moment was reached. Balls beyond have its outermost cells.
Schedule scene_schedule(const Settings& settings, const Box& scene_box, const WallShift& walls, double largest_radius,
                        const Variety& variety, std::uint32_t ball_count) {
    const Box wanted = shifted(scene_box, {settings.walls_low, settings.walls_high, dvec3(0.0), 0.0});
    const Grid grid = make_grid(united(scene_box, wanted), largest_radius, settings.cell_factor, ball_count);
    const bool moving = walls_move(walls, settings, scene_box, 2.0 * largest_radius);
    const SortMethod sort = settings.sort == SortMethod::automatic ? SortMethod::bitonic_fused : settings.sort;
    return make_schedule(ball_count, grid, features_of(settings, variety, moving), sort, settings.grid_reuse);
}

Schedule first_schedule(const Scene& scene) {
    const std::uint64_t seed = scene.fill ? scene.fill->seed : 0;
    return first_schedule(
        scene, scene.settings.laws.contact ? make_world(scene, scene.settings.balls, seed) : sample_of(scene));
}

std::vector<Program> shipped_programs(std::span<const Scene> scenes) {
    std::set<Program> programs;
    for (const Scene& scene : scenes) {
        for (const Dispatch& dispatch : first_schedule(scene, sample_of(scene)).dispatches) {
            programs.insert(dispatch.program);
        }
    }
    return {programs.begin(), programs.end()};
}

}  // namespace ballpit
