// The box as it is drawn, and the room around it that the eye is set up for.
#pragma once

#include "core/simulation.h"
#include "view/overlay.h"

namespace ballpit::app {

/// m: the box where it stands.
view::Box drawn_box(const Simulation& simulation);

/// m: half the size of the smallest room around the origin that holds the scene's box and the one that stands there,
/// however far it is being shaken. It stays while the box swings, and so do camera, light and shadows.
vec3 room_half_extent(const Simulation& simulation);

}  // namespace ballpit::app
