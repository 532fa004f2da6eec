#include "app/window_start.h"

#include "app/budget.h"
#include "app/commands.h"
#include "app/share_code.h"
#include "app/shared_run.h"
#include "app/user_folders.h"
#include "app/window.h"
#include "core/error.h"

namespace ballpit::app {

namespace {

// The command line says what to show: then nothing that was left yesterday counts.
bool chosen(const Options& options) {
    return options.scene_given || !options.set.empty() || options.seed || options.relax || !options.code.empty();
}

// All at once and in no order: a law that was added decides which of the others apply.
Setup last_setup(Options options, const UserSettings& user) {
    options.scene = user.scene;
    options.seed = user.seed;
    Setup setup = make_setup(options);
    assign_settings(setup.settings, {user.changed.begin(), user.changed.end()});
    return setup;
}

}  // namespace

// A scene file that is gone, or a setting that it no longer has, must not keep the window from opening.
Setup make_window_setup(const Options& options, const UserSettings& user, std::string& message) {
    if (!chosen(options) && !user.scene.empty()) {
        try {
            return last_setup(options, user);
        } catch (const InputError& error) {
            message = "The last scene does not come back: " + std::string(error.what());
        }
    }
    return make_setup(options);
}

int open_window(const Options& options) {
    check_budget(options);
    WindowOptions window;
    window.user_folder = config_folder();
    if (!options.fresh) {
        LoadedSettings loaded = load_user_settings(window.user_folder);
        window.user = std::move(loaded.settings);
        window.message = std::move(loaded.message);
    }
    Setup setup = make_window_setup(options, window.user, window.message);
    window.gallery = list_scenes(setup.paths.assets);
    if (!options.code.empty()) {
        shared_scene(decode_share_code(options.code), window.gallery);  // what is wrong with it is told at once
        window.code = options.code;
    }
    window.scene = std::move(setup.scene);
    window.scene_file = setup.scene_file.string();
    window.settings = setup.settings;
    window.budget = parse_budget(options.budget);
    window.seed = setup.seed;
    window.relax = options.relax;
    // What is remembered is a wish: on another machine the GPU that was asked for may not be there.
    const bool remembered_cpu = window.user.backend == "cpu" || window.user.backend == "threads";
    window.backend = remembered_cpu && !options.backend_given ? window.user.backend : options.backend;
    window.assets_folder = setup.paths.assets;
    window.shader_folder = setup.paths.shaders;
    window.model_file =
        options.model.empty() ? setup.paths.assets / "models" / "ball.obj" : std::filesystem::path(options.model);
    return run_window(window);
}

}  // namespace ballpit::app
