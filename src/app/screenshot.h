// A picture of a simulation, drawn off screen.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/options.h"
#include "app/paths.h"
#include "app/share_code.h"
#include "core/simulation.h"
#include "gl/framebuffer.h"
#include "view/renderer.h"

namespace ballpit::app {

class Screenshot {
public:
    /// Needs a current context. Throws InputError (model), gl::ShaderError or gl::Error (size).
    Screenshot(const Paths& paths, const Options& options);

    /// Draws the state as it is and writes the PNG; with a code, as its sender looked at it, without the overlays.
    void save(Simulation& simulation, const std::optional<SharedCode>& code = std::nullopt);

private:
    void draw_as_sent(Simulation& simulation, const SharedCode& code);

    std::string file_;
    std::filesystem::path shader_folder_;
    std::filesystem::path model_file_;
    view::Look look_;
    view::Renderer renderer_;
    gl::Framebuffer framebuffer_;
};

}  // namespace ballpit::app
