#include "app/screenshot.h"

#include "app/home_picture.h"
#include "app/window_picture.h"
#include "view/image.h"

namespace ballpit::app {

namespace {

std::filesystem::path model_file(const Paths& paths, const Options& options) {
    return options.model.empty() ? paths.assets / "models" / "ball.obj" : std::filesystem::path(options.model);
}

}  // namespace

Screenshot::Screenshot(const Paths& paths, const Options& options)
    : file_(options.screenshot),
      shader_folder_(paths.shaders),
      model_file_(model_file(paths, options)),
      look_(options.look == "impostor" ? view::Look::impostor
            : options.look == "simple" ? view::Look::simple
                                       : view::Look::model),
      renderer_(paths.shaders, view::load_model(model_file_)),
      framebuffer_(options.width, options.height) {}

void Screenshot::draw_as_sent(Simulation& simulation, const SharedCode& code) {
    const PictureArea area{0, 0, framebuffer_.width(), framebuffer_.height()};
    PictureOptions options;
    options.view = code.shown.view;
    options.light = light_of(code.shown.light);
    options.camera = code.camera.value_or(
        view::home(vec3(simulation.half_extent()), static_cast<float>(area.width) / static_cast<float>(area.height)));
    WindowPicture picture(shader_folder_, model_file_, false);
    framebuffer_.bind();
    picture.draw_background(area);
    picture.draw(simulation, 0, options, area);
    view::save_png(file_, area.width, area.height, framebuffer_.pixels());
}

void Screenshot::save(Simulation& simulation, const std::optional<SharedCode>& code) {
    if (code) {
        draw_as_sent(simulation, *code);
        return;
    }
    DrawnBuffers buffers;
    const view::Picture picture = home_picture(simulation, buffers, look_, framebuffer_.width(), framebuffer_.height());
    framebuffer_.bind();
    renderer_.draw(picture);
    view::save_png(file_, picture.width, picture.height, framebuffer_.pixels());
}

}  // namespace ballpit::app
