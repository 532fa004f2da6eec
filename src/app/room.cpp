#include "app/room.h"

namespace ballpit::app {

view::Box drawn_box(const Simulation& simulation) {
    const Box box = simulation.box();
    return {vec3(box.lower), vec3(box.upper)};
}

vec3 room_half_extent(const Simulation& simulation) {
    WallShift still = simulation.wall_shift();
    const dvec3 swung = still.shake;
    still.shake = dvec3(0.0);
    const Settings& settings = simulation.settings();
    const dvec3 swing = settings.laws.shake ? 2.0 * glm::abs(settings.shake_amplitude) : glm::abs(swung);
    const Box& scene_box = simulation.scene_box();
    return vec3(glm::max(scene_box.half_extent(), shifted(scene_box, still).half_extent() + swing));
}

}  // namespace ballpit::app
