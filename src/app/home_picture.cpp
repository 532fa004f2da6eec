#include "app/home_picture.h"

#include "app/room.h"

namespace ballpit::app {

view::Picture home_picture(Simulation& simulation, DrawnBuffers& buffers, view::Look look, int width, int height) {
    view::Picture picture;
    picture.positions = buffers.positions(simulation.backend());
    picture.ball_count = simulation.schedule().ball_count;
    picture.grid = simulation.schedule().grid;
    picture.half_extent = room_half_extent(simulation);
    picture.box = drawn_box(simulation);
    picture.width = width;
    picture.height = height;
    picture.camera = view::home(picture.half_extent, static_cast<float>(width) / static_cast<float>(height));
    picture.look = look;
    return picture;
}

}  // namespace ballpit::app
