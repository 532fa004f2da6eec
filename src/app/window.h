// The window: what a lecturer sees and steers.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/gallery.h"
#include "app/user_settings.h"
#include "core/scene.h"
#include "measure/error_budget.h"

namespace ballpit::app {

struct WindowOptions {
    Scene scene;
    std::string scene_file;
    std::vector<SceneEntry> gallery;              // what [ and ] go through; the scene need not be among them
    Settings settings;                            // the scene's, with --set
    std::optional<measure::BudgetPreset> budget;  // chooses the substeps to begin with
    std::uint64_t seed = 0;
    std::string backend = "auto";  // auto, gpu, cpu, threads
    std::filesystem::path assets_folder;
    std::filesystem::path shader_folder;
    std::filesystem::path model_file;
    int width = 1280;  // points
    int height = 720;
    UserSettings user;                  // what was remembered
    std::filesystem::path user_folder;  // where that goes
    std::string message;                // to begin with
    bool relax = false;                 // pushes balls that overlap apart first
    std::string code;                   // a share code to open; has been looked at
};

/// Opens the window and runs until it is closed; the exit code. Throws InputError, DeviceError or gl::Error for what
/// keeps it from starting: no display, no OpenGL 3.3, a broken model or shader, a scene that does not fit.
/// What fails later is told on screen, and the running scene goes on.
int run_window(const WindowOptions& options);

}  // namespace ballpit::app
