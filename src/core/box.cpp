#include "core/box.h"

#include <cmath>
#include <numbers>

namespace ballpit {

namespace {

// Where the walls are to go. Each may come up to the middle of the box, less half the room that must stay.
struct Wanted {
    dvec3 low;
    dvec3 high;
};

Wanted wanted_shift(const Settings& settings, const Box& scene_box, double room) {
    const dvec3 slack = glm::max(0.5 * (scene_box.size() - room), dvec3(0.0));
    return {glm::min(settings.walls_low, slack), glm::max(settings.walls_high, -slack)};
}

dvec3 approach(const dvec3& from, const dvec3& to, double distance) {
    return from + glm::clamp(to - from, dvec3(-distance), dvec3(distance));
}

bool shakes(const Settings& settings) { return settings.laws.shake && settings.shake_amplitude != dvec3(0.0); }

}  // namespace

Box united(const Box& a, const Box& b) { return {glm::min(a.lower, b.lower), glm::max(a.upper, b.upper)}; }

Box shifted(const Box& scene_box, const WallShift& shift) {
    return {scene_box.lower + (shift.low + shift.shake), scene_box.upper + (shift.high + shift.shake)};
}

WallShift advance(const WallShift& shift, const Settings& settings, const Box& scene_box, double room, double dt) {
    const Wanted wanted = wanted_shift(settings, scene_box, room);
    WallShift next = shift;
    next.low = approach(shift.low, wanted.low, settings.wall_speed * dt);
    next.high = approach(shift.high, wanted.high, settings.wall_speed * dt);
    if (shakes(settings)) {
        // Phases are kept small, so that sin() stays accurate however long the box is shaken.
        const double after = shift.shake_phase + 2.0 * std::numbers::pi * settings.shake_frequency * dt;
        next.shake += settings.shake_amplitude * (std::sin(after) - std::sin(shift.shake_phase));
        next.shake_phase = std::fmod(after, 2.0 * std::numbers::pi);
    }
    return next;
}

bool walls_move(const WallShift& shift, const Settings& settings, const Box& scene_box, double room) {
    const Wanted wanted = wanted_shift(settings, scene_box, room);
    return settings.laws.walls && (shakes(settings) || shift.low != wanted.low || shift.high != wanted.high);
}

Walls moving_walls(const Box& scene_box, const WallShift& from, const WallShift& to, double dt) {
    const Box box = shifted(scene_box, from);
    if (dt <= 0.0) {
        return box;
    }
    return {box, ((to.low + to.shake) - (from.low + from.shake)) / dt,
            ((to.high + to.shake) - (from.high + from.shake)) / dt};
}

}  // namespace ballpit
