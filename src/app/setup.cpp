#include "app/setup.h"

#include "app/gallery.h"
#include "core/error.h"
#include "core/scene_file.h"
#include "cpu/cpu_backend.h"
#include "cpu/threaded_backend.h"
#include "gl/error.h"
#include "gpu/gpu_backend.h"

namespace ballpit::app {

namespace {

void apply_setting(Setup& setup, const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) {
        throw InputError("--set " + text + ": expected KEY=VALUE");
    }
    const std::string key = text.substr(0, equals);
    const SettingInfo* info = find_setting(key);
    if (info != nullptr && !setting_applies(*info, setup.settings.laws)) {
        throw InputError("--set " + text + ": scene '" + setup.scene.name + "' has no law that uses '" + key + "'");
    }
    assign_setting(setup.settings, key, text.substr(equals + 1));
}

}  // namespace

Setup make_setup(const Options& options) {
    Setup setup;
    setup.paths = find_paths();
    setup.scene_file = find_scene(setup.paths.assets, options.scene);
    setup.scene = load_scene(setup.scene_file);
    setup.settings = setup.scene.settings;
    for (const std::string& text : options.set) {
        apply_setting(setup, text);
    }
    setup.seed = options.seed.value_or(setup.scene.fill ? setup.scene.fill->seed : 0);
    return setup;
}

std::unique_ptr<Backend> make_cpu_backend(std::string_view choice) {
    if (choice == "threads") {
        return std::make_unique<cpu::ThreadedBackend>();
    }
    return std::make_unique<cpu::CpuBackend<float>>();
}

Device open_device(const std::string& choice, const std::filesystem::path& shaders, bool picture) {
    Device device;
    const bool on_cpu = choice == "cpu" || choice == "threads";
    if (!on_cpu || picture) {
        try {
            gl::ContextOptions options;
            options.visible = false;
            device.context = std::make_unique<gl::Context>(options);
        } catch (const gl::Error& error) {
            if (choice == "gpu" || picture) {
                throw;
            }
            device.note = std::string("the CPU mirror computes: ") + error.what();
        }
    }
    const bool has_compute = device.context != nullptr && device.context->has_compute();
    if (choice == "gpu" || (choice == "auto" && has_compute)) {
        device.backend = std::make_unique<gpu::GpuBackend>(shaders);
        return device;
    }
    if (choice == "auto" && device.note.empty()) {
        device.note =
            "the CPU mirror computes: the stages need OpenGL 4.3, this context has " + device.context->version();
    }
    device.backend = make_cpu_backend(choice);
    return device;
}

Simulation make_simulation(const Setup& setup, Device& device) {
    return {setup.scene, setup.settings, setup.seed, std::move(device.backend)};
}

}  // namespace ballpit::app
