// An SDL window with an OpenGL context: GL 4.3 core where the driver has it, else 3.3 core, which is enough to draw.
#pragma once

#include <SDL.h>

#include <memory>
#include <string>

namespace ballpit::gl {

struct ContextOptions {
    std::string title = "Ball Pit";
    int width = 1280;
    int height = 720;
    bool visible = true;  // false: for headless work and tests
    bool debug = false;   // ask for a debug context and collect messages (debug.h)
};

class Context {
public:
    /// Initialises SDL's video part. A context that is not to be seen uses SDL's offscreen driver unless
    /// SDL_VIDEODRIVER says otherwise. Throws Error: no display, or no OpenGL 3.3.
    explicit Context(const ContextOptions& options);
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    SDL_Window* window() const { return window_; }
    SDL_GLContext handle() const { return context_; }
    bool has_compute() const { return has_compute_; }  // GL 4.3
    std::string renderer() const;                      // GL_RENDERER
    std::string version() const;                       // GL_VERSION

private:
    bool create(const ContextOptions& options, int major, int minor);

    SDL_Window* window_ = nullptr;
    SDL_GLContext context_ = nullptr;
    bool has_compute_ = false;
};

}  // namespace ballpit::gl
