// What is seen of a simulation before anybody has moved the camera.
#pragma once

#include "app/drawn_buffers.h"
#include "core/simulation.h"
#include "view/picture.h"

namespace ballpit::app {

/// `buffers` holds what the picture points to; anew for each picture, since the buffers change places.
view::Picture home_picture(Simulation& simulation, DrawnBuffers& buffers, view::Look look, int width, int height);

}  // namespace ballpit::app
