// A picture of a simulation, drawn off screen.
#pragma once

#include <string>

#include "app/options.h"
#include "app/paths.h"
#include "core/simulation.h"
#include "gl/framebuffer.h"
#include "view/renderer.h"

namespace ballpit::app {

class Screenshot {
public:
    /// Needs a current context. Throws InputError (model), gl::ShaderError or gl::Error (size).
    Screenshot(const Paths& paths, const Options& options);

    /// Draws the state as it is and writes the PNG.
    void save(Simulation& simulation);

private:
    std::string file_;
    view::Look look_;
    view::Renderer renderer_;
    gl::Framebuffer framebuffer_;
};

}  // namespace ballpit::app
