#include "app/window_picture.h"

#include "app/room.h"

namespace ballpit::app {

namespace {

view::BallColour drawn_colour(ui::BallColour colour, const gl::Buffer* values) {
    if (ui::is_worked_out(colour)) {
        return values == nullptr ? view::BallColour::plain : view::BallColour::value;
    }
    return static_cast<view::BallColour>(colour);
}

view::Look look_of(ui::Look look, bool software) {
    switch (ui::drawn_look(look, software)) {
        case ui::Look::impostor:
            return view::Look::impostor;
        case ui::Look::simple:
            return view::Look::simple;
        case ui::Look::model:
        case ui::Look::automatic:
            break;
    }
    return view::Look::model;
}

}  // namespace

ui::LightOptions light_options(const view::Light& light) {
    return {light.orbiting, light.angle,  light.radius_factor, light.height,
            light.speed,    light.colour, light.intensity,     light.ambient};
}

view::Light light_of(const ui::LightOptions& options) {
    return {options.orbiting, options.angle,  options.distance,   options.height,
            options.speed,    options.colour, options.brightness, options.ambient};
}

WindowPicture::WindowPicture(const std::filesystem::path& shader_folder, const std::filesystem::path& model_file,
                             bool software)
    : renderer_(shader_folder, view::load_model(model_file)), software_(software) {}

void WindowPicture::draw(Simulation& simulation, std::size_t side, const PictureOptions& options,
                         const PictureArea& area) {
    Backend& backend = simulation.backend();
    DrawnBuffers& buffers = buffers_[side];
    const Schedule& schedule = simulation.schedule();
    const ui::ViewOptions& view = options.view;
    const bool arrows = options.overlay != nullptr && options.overlay->arrow_seconds > 0.0f;
    const bool slice = options.overlay != nullptr && options.overlay->slice;
    view::Picture picture;
    picture.positions = buffers.positions(backend);
    picture.ball_count = schedule.ball_count;
    if (view.colour == ui::BallColour::speed || arrows) {
        picture.velocities = buffers.velocities(backend);
    }
    picture.show_cells = view.occupancy && schedule.cell_count > 0;
    if (picture.show_cells || (slice && schedule.cell_count > 0)) {
        picture.cell_ranges = buffers.cell_ranges(backend);
    }
    picture.grid = schedule.grid;
    picture.half_extent = room_half_extent(simulation);
    picture.box = drawn_box(simulation);
    picture.camera = options.camera;
    picture.light = options.light;
    picture.look = look_of(options.view.look, software_);
    picture.ball_colour = drawn_colour(view.colour, options.values);
    picture.values = options.values;
    picture.value_low = options.value_low;
    picture.value_high = options.value_high;
    picture.top_speed = options.top_speed;
    picture.show_box = view.box;
    picture.show_ground = view.ground;
    picture.show_light = view.light;
    picture.top_count = options.top_count;
    picture.overlay = options.overlay;
    picture.time_s = options.time_s;
    picture.x = area.x;
    picture.y = area.y;
    picture.width = area.width;
    picture.height = area.height;
    if (picture.look == view::Look::simple && (software_ || backend.name() != "gpu")) {
        buffers.set_order(backend, picture);
    }
    renderer_.draw(picture);
}

void WindowPicture::draw_background(const PictureArea& area) {
    view::Picture picture;
    picture.show_box = picture.show_ground = picture.show_light = picture.show_shadows = false;
    picture.x = area.x;
    picture.y = area.y;
    picture.width = area.width;
    picture.height = area.height;
    renderer_.draw(picture);
}

}  // namespace ballpit::app
