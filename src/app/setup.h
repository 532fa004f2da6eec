// From options to what a command works with: scene, settings, seed, and the device that computes.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "app/options.h"
#include "app/paths.h"
#include "core/backend.h"
#include "core/scene.h"
#include "core/simulation.h"
#include "gl/context.h"

namespace ballpit::app {

struct Setup {
    Paths paths;
    std::filesystem::path scene_file;
    Scene scene;
    Settings settings;  // the scene's, with --set
    std::uint64_t seed = 0;
};

/// Reads the scene and applies --set. Throws InputError: no such scene, a bad file, a setting that does not exist,
/// does not parse, is out of range or belongs to a law that the scene does not have.
Setup make_setup(const Options& options);

/// A context, where one is needed, and the backend on it.
struct Device {
    std::unique_ptr<gl::Context> context;  // null where nothing needs OpenGL
    std::unique_ptr<Backend> backend;
    std::string note;  // why `auto` did not take the GPU; else empty
};

/// The threaded one for "threads", the mirror for everything else.
std::unique_ptr<Backend> make_cpu_backend(std::string_view choice);

/// `choice`: auto, gpu, cpu or threads. With `picture` the context is made for the CPU backends, too, to draw with.
/// Throws gl::Error where OpenGL is needed and not there; `auto` without a picture never does.
Device open_device(const std::string& choice, const std::filesystem::path& shaders, bool picture);

/// A simulation of the setup on the device's backend, which it takes.
Simulation make_simulation(const Setup& setup, Device& device);

}  // namespace ballpit::app
