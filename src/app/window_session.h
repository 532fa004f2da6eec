// What runs in the window: the simulation, the settings the user asks for, and the scenes to choose from. Whatever
// the user asks for that cannot be had becomes a sentence, and the running scene goes on.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/window.h"
#include "core/simulation.h"
#include "ui/state.h"

namespace ballpit::app {

class Session {
public:
    /// `gl_version`: of the current context; `has_compute`: whether it is 4.3. Throws as run_window.
    Session(const WindowOptions& options, bool has_compute, const std::string& gl_version);

    Simulation& simulation() { return *simulation_; }
    const Simulation& simulation() const { return *simulation_; }

    void step();
    void restart(bool new_seed);
    void choose_scene(std::size_t index);
    void next_scene(int offset);  // around the end
    void choose_backend(ui::BackendChoice choice);
    void clear_status();

    /// Settings as the panel shows them; apply() makes them the simulation's. While a slider is `held`, a change that
    /// rebuilds a world of many balls waits for its release.
    void want(const Settings& settings) { wanted_ = settings; }
    void apply(bool held);

    /// Fills the cells for who looks at them before the first substep has run.
    void prepare_cells();

    /// Adds what the panels read of it.
    void describe(ui::State& state) const;

    /// Another number: another scene, hence another box to look at.
    int scene_changes() const { return scene_changes_; }
    /// Another number: the buffers have changed.
    std::uint64_t revision() const { return revision_; }
    std::string take_message() { return std::exchange(message_, {}); }

private:
    std::unique_ptr<Backend> make_backend(ui::BackendChoice choice) const;
    void list_scenes(const WindowOptions& options);
    bool attempt(const std::function<void()>& change);

    bool has_compute_;
    std::filesystem::path shader_folder_;
    std::vector<std::filesystem::path> scene_files_;
    std::vector<ui::SceneChoice> scenes_;
    std::size_t scene_ = 0;
    ui::BackendChoice choice_ = ui::BackendChoice::automatic;
    std::unique_ptr<Simulation> simulation_;
    Settings wanted_;
    bool cells_ready_ = false;
    int scene_changes_ = 0;
    std::uint64_t revision_ = 0;
    std::string message_;
};

}  // namespace ballpit::app
