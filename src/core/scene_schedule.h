// What a scene asks for, before it runs: the schedule of its first substep, and the programs of a whole gallery.
#pragma once

#include <span>
#include <vector>

#include "core/scene.h"
#include "core/schedule.h"
#include "core/world.h"

namespace ballpit {

/// The schedule of `ball_count` balls in a box whose walls have moved by `walls`. `largest_radius` (m) and `variety`
/// are those of the balls.
Schedule scene_schedule(const Settings& settings, const Box& scene_box, const WallShift& walls, double largest_radius,
                        const Variety& variety, std::uint32_t ball_count);

/// The first substep of a scene with the settings it starts with. Makes its balls, where the grid depends on them.
Schedule first_schedule(const Scene& scene);

/// The programs that the first substeps of these scenes run, each once, in order. Makes a ball or two a scene, so it is
/// quick for any count.
std::vector<Program> shipped_programs(std::span<const Scene> scenes);

}  // namespace ballpit
