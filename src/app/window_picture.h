// The picture behind the panels: from the simulation's buffers, as the panels' options ask for.
#pragma once

#include <array>
#include <filesystem>

#include "app/drawn_buffers.h"
#include "core/simulation.h"
#include "ui/options.h"
#include "view/renderer.h"

namespace ballpit::app {

/// The light as the panel shows it, and back.
ui::LightOptions light_options(const view::Light& light);
view::Light light_of(const ui::LightOptions& options);

/// A part of the window, pixels from its lower left corner.
struct PictureArea {
    int x = 0;
    int y = 0;
    int width = 1280;
    int height = 720;
};

/// What a picture needs beside the simulation.
struct PictureOptions {
    ui::ViewOptions view;
    view::Camera camera;
    view::Light light;
    const view::Overlay* overlay = nullptr;
    std::uint32_t top_count = 8;  // balls in a cell that get the last colour
    float top_speed = 10.0f;      // m/s
    float time_s = 0.0f;          // what blinks goes by it

    // For colours that are worked out; null: not there yet, and the balls are plain.
    const gl::Buffer* values = nullptr;
    float value_low = 0.0f;
    float value_high = 1.0f;
};

class WindowPicture {
public:
    /// Throws gl::ShaderError for a broken shader, InputError for a broken model.
    /// `software`: whether a CPU draws.
    WindowPicture(const std::filesystem::path& shader_folder, const std::filesystem::path& model_file, bool software);

    /// `side`: 0, or 1 for the second simulation of a split screen.
    void draw(Simulation& simulation, std::size_t side, const PictureOptions& options, const PictureArea& area);

    /// Only what lies behind everything.
    void draw_background(const PictureArea& area);

private:
    view::Renderer renderer_;
    bool software_;
    std::array<DrawnBuffers, 2> buffers_;
};

}  // namespace ballpit::app
