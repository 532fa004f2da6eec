// A scene as the text of a scene file (docs/scenes.md), and the present moment of a run as a scene.
#pragma once

#include <string>

#include "core/scene.h"
#include "core/simulation.h"

namespace ballpit {

/// What `parse_scene` reads back as the same scene, value by value: numbers are as short as they can be without another
/// value. One line a ball. Laws that only show what they cost, a pull and what the scene promises (bounds) are left
/// out.
std::string scene_text(const Scene& scene);

/// The scene with the settings and the seed that it has now, as it starts; balls that were thrown in are not part of
/// it. Asks nothing of the device, for who has none any more.
Scene scene_as_set(const Simulation& simulation);

/// The state as it is at the start of the present substep: every ball in its list, the fill empty, ready to give more.
/// Loaded and run on, it gives the bytes that the simulation gives. A hand lets go. Waits for the device. Throws
/// InputError where a ball has a number that no file can hold.
Scene scene_of_moment(Simulation& simulation);

}  // namespace ballpit
