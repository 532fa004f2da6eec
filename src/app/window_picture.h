// The picture behind the panels: from the simulation's buffers, as the panels' options ask for.
#pragma once

#include <filesystem>

#include "app/drawn_buffers.h"
#include "core/simulation.h"
#include "ui/options.h"
#include "view/renderer.h"

namespace ballpit::app {

/// The light as the panel shows it, and back.
ui::LightOptions light_options(const view::Light& light);
view::Light light_of(const ui::LightOptions& options);

class WindowPicture {
public:
    /// Throws gl::ShaderError for a broken shader, InputError for a broken model.
    WindowPicture(const std::filesystem::path& shader_folder, const std::filesystem::path& model_file);

    /// `time_s`: what blinks goes by it. `top_count`: balls in a cell that get the last colour. Sizes in pixels.
    void draw(Simulation& simulation, const ui::ViewOptions& options, const view::Camera& camera,
              const view::Light& light, const view::Overlay& overlay, std::uint32_t top_count, float time_s, int width,
              int height);

private:
    view::Renderer renderer_;
    DrawnBuffers buffers_;
};

}  // namespace ballpit::app
