#include "app/screenshot.h"

#include "app/drawn_buffers.h"
#include "view/image.h"

namespace ballpit::app {

namespace {

std::filesystem::path model_file(const Paths& paths, const Options& options) {
    return options.model.empty() ? paths.assets / "models" / "ball.obj" : std::filesystem::path(options.model);
}

}  // namespace

Screenshot::Screenshot(const Paths& paths, const Options& options)
    : file_(options.screenshot),
      look_(options.look == "impostor" ? view::Look::impostor : view::Look::model),
      renderer_(paths.shaders, view::load_model(model_file(paths, options))),
      framebuffer_(options.width, options.height) {}

void Screenshot::save(Simulation& simulation) {
    DrawnBuffers buffers;
    view::Picture picture;
    picture.positions = buffers.positions(simulation.backend());
    picture.ball_count = simulation.schedule().ball_count;
    picture.grid = simulation.schedule().grid;
    picture.half_extent = vec3(simulation.half_extent());
    picture.width = framebuffer_.width();
    picture.height = framebuffer_.height();
    picture.camera =
        view::home(picture.half_extent, static_cast<float>(picture.width) / static_cast<float>(picture.height));
    picture.look = look_;
    framebuffer_.bind();
    renderer_.draw(picture);
    view::save_png(file_, picture.width, picture.height, framebuffer_.pixels());
}

}  // namespace ballpit::app
