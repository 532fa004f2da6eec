#include "gl/context.h"

#include <glad/gl.h>

#include "gl/debug.h"
#include "gl/error.h"
#include "gl/reset.h"

namespace ballpit::gl {

namespace {

std::string gl_string(GLenum name) {
    const auto* text = reinterpret_cast<const char*>(glGetString(name));
    return text == nullptr ? "" : text;
}

void init_video(bool visible) {
    if (!visible) {
        SDL_SetHint(SDL_HINT_VIDEODRIVER, "offscreen");  // a hint gives way to the environment variable
    }
    if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) {
        throw Error(std::string("no display to open a window on: ") + SDL_GetError());
    }
}

// One that tells of resets (reset.h), and has lost everything then, where driver and window system offer it.
SDL_GLContext context_of(SDL_Window* window) {
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_RESET_NOTIFICATION, SDL_GL_CONTEXT_RESET_LOSE_CONTEXT);
    SDL_GLContext context = SDL_GL_CreateContext(window);
    if (context == nullptr) {
        SDL_GL_SetAttribute(SDL_GL_CONTEXT_RESET_NOTIFICATION, SDL_GL_CONTEXT_RESET_NO_NOTIFICATION);
        context = SDL_GL_CreateContext(window);
    }
    return context;
}

}  // namespace

Context::Context(const ContextOptions& options) {
    init_video(options.visible);
    if (!create(options, 4, 3) && !create(options, 3, 3)) {
        const std::string reason = SDL_GetError();
        SDL_QuitSubSystem(SDL_INIT_VIDEO);
        throw Error("no OpenGL 3.3 or newer: " + reason);
    }
    has_compute_ = GLAD_GL_VERSION_4_3 != 0;
    if (options.debug) {
        collect_messages();
    }
}

bool Context::create(const ContextOptions& options, int major, int minor) {
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, major);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, minor);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_FLAGS,
                        (options.debug ? SDL_GL_CONTEXT_DEBUG_FLAG : 0) | SDL_GL_CONTEXT_FORWARD_COMPATIBLE_FLAG);
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 24);
    const Uint32 flags = SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI |
                         (options.visible ? SDL_WINDOW_SHOWN : SDL_WINDOW_HIDDEN);
    window_ = SDL_CreateWindow(options.title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, options.width,
                               options.height, flags);
    if (window_ == nullptr) {
        return false;
    }
    context_ = context_of(window_);
    const bool loaded = context_ != nullptr && gladLoadGL(reinterpret_cast<GLADloadfunc>(SDL_GL_GetProcAddress)) != 0;
    if (!loaded || GLAD_GL_VERSION_3_3 == 0) {
        if (context_ != nullptr) {
            SDL_GL_DeleteContext(context_);
            context_ = nullptr;
        }
        SDL_DestroyWindow(window_);
        window_ = nullptr;
        return false;
    }
    watch_resets(reinterpret_cast<GLADloadfunc>(SDL_GL_GetProcAddress));
    return true;
}

Context::~Context() {
    SDL_GL_DeleteContext(context_);
    SDL_DestroyWindow(window_);
    SDL_QuitSubSystem(SDL_INIT_VIDEO);
}

std::string Context::renderer() const { return gl_string(GL_RENDERER); }

std::string Context::version() const { return gl_string(GL_VERSION); }

}  // namespace ballpit::gl
