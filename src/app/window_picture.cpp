#include "app/window_picture.h"

namespace ballpit::app {

ui::LightOptions light_options(const view::Light& light) {
    return {light.orbiting, light.angle,  light.radius_factor, light.height,
            light.speed,    light.colour, light.intensity,     light.ambient};
}

view::Light light_of(const ui::LightOptions& options) {
    return {options.orbiting, options.angle,  options.distance,   options.height,
            options.speed,    options.colour, options.brightness, options.ambient};
}

WindowPicture::WindowPicture(const std::filesystem::path& shader_folder, const std::filesystem::path& model_file)
    : renderer_(shader_folder, view::load_model(model_file)) {}

void WindowPicture::draw(Simulation& simulation, const ui::ViewOptions& options, const view::Camera& camera,
                         const view::Light& light, const view::Overlay& overlay, std::uint32_t top_count, float time_s,
                         int width, int height) {
    Backend& backend = simulation.backend();
    const Schedule& schedule = simulation.schedule();
    view::Picture picture;
    picture.positions = buffers_.positions(backend);
    picture.ball_count = schedule.ball_count;
    if (options.colour == ui::BallColour::speed) {
        picture.velocities = buffers_.velocities(backend);
    }
    picture.show_cells = options.occupancy && schedule.cell_count > 0;
    if (picture.show_cells) {
        picture.cell_ranges = buffers_.cell_ranges(backend);
    }
    picture.grid = schedule.grid;
    picture.half_extent = vec3(simulation.half_extent());
    picture.camera = camera;
    picture.light = light;
    picture.look = options.look == ui::Look::impostor ? view::Look::impostor : view::Look::model;
    picture.ball_colour = static_cast<view::BallColour>(options.colour);
    picture.show_box = options.box;
    picture.show_ground = options.ground;
    picture.show_light = options.light;
    picture.top_count = top_count;
    picture.overlay = &overlay;
    picture.time_s = time_s;
    picture.width = width;
    picture.height = height;
    renderer_.draw(picture);
}

}  // namespace ballpit::app
