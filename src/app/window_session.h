// What runs in the window: the simulation, the settings the user asks for, and the scenes to choose from. Whatever
// the user asks for that cannot be had becomes a sentence, and the running scene goes on.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/shared_run.h"
#include "app/window.h"
#include "core/scene_writer.h"
#include "core/simulation.h"
#include "core/stepper.h"
#include "gpu/programs.h"
#include "ui/state.h"

namespace ballpit::app {

/// Bytes of checkpoints on the device, at first.
inline constexpr std::size_t default_checkpoint_budget = std::size_t{256} << 20;

/// Where a scene comes from.
struct SceneSource {
    std::string name;            // in the gallery; empty: from elsewhere
    std::filesystem::path file;  // empty: the text
    std::string text;
};

class Session {
public:
    /// Of the current context: `has_compute`, whether it is 4.3; `gl_version`; `software`, whether a CPU draws. Throws
    /// as run_window.
    Session(const WindowOptions& options, bool has_compute, const std::string& gl_version, bool software = false);

    Simulation& simulation() { return *simulation_; }
    const Simulation& simulation() const { return *simulation_; }

    /// What runs, forth and back: nothing else runs the simulation. The members below keep settings and revision in
    /// step with it; whoever calls the stepper itself must not move it.
    Stepper& stepper() { return *stepper_; }

    void step() { forward(StepUnit::step); }
    void forward(StepUnit unit);
    void back(StepUnit unit);
    void to_step_start();
    void to_step_end();
    void go_to(const ui::Place& place);
    ui::Place place() const;
    /// Runs what has run of the substep shown once more; `before`: just before that.
    void run_again(const std::function<void()>& before);
    /// Once a frame: hashes that have arrived.
    void update() { stepper_->update(); }

    void restart(bool new_seed);
    void choose_scene(std::size_t index);
    void next_scene(int offset);  // around the end
    /// A scene file from elsewhere, which then stands among the scenes to choose from.
    void open_file(const std::filesystem::path& file);

    /// What the code's run needs: scene, seed, changes, position, hash, device.
    void describe(SharedCode& code);
    /// Starts the scene of a code anew, with what it began with. False: refused, with a sentence.
    bool open(const SharedCode& code);
    /// A slice of the way to what the code shows (s); true once it has arrived, or cannot.
    bool replay(Replay& replay, double seconds);
    /// For who saves it: the scene as it is at the start of the present substep.
    Scene scene_of_moment() { return ballpit::scene_of_moment(*simulation_); }
    /// Where the device is gone and its balls with it: writes the scene as it was set, which starts anew, into the
    /// folder. A sentence that says where it is, or why not.
    std::string rescue(const std::filesystem::path& folder) const;
    /// Name in the gallery, or the file's without its ending.
    std::string scene_stem() const;
    /// What is to come back another day: scene, and the settings that are not its own.
    void describe(UserSettings& user) const;
    void choose_backend(ui::BackendChoice choice);
    void clear_status();

    /// Settings as the panel shows them; apply() makes them the simulation's. While a slider is `held`, a change that
    /// rebuilds a world of many balls waits for its release.
    void want(const Settings& settings) { wanted_ = settings; }
    const Settings& wanted() const { return wanted_; }
    void apply(bool held);

    /// Throws balls in; false where that is refused, and told. Settings still waiting are applied first.
    bool add_balls(std::vector<BallSpec> balls);
    /// Pushes balls that overlap apart; as add_balls().
    bool relax();

    /// Fills the cells for who looks at them before the first substep has run.
    void prepare_cells();

    /// Another backend of the kind that computes here. Throws as its constructor does.
    std::unique_ptr<Backend> twin_backend() const;

    /// What the GPU backends of this window run; nothing is compiled where the mirror computes.
    gpu::Programs& programs() { return *programs_; }
    const gpu::Programs& programs() const { return *programs_; }

    /// Adds what the panels read of it.
    void describe(ui::State& state) const;
    void describe(ui::SteppingState& state) const;

    /// Another number: another scene, hence another box to look at.
    int scene_changes() const { return scene_changes_; }
    /// Another number: the buffers have changed.
    std::uint64_t revision() const { return revision_; }
    /// Another number: the buffers may have other sizes, or belong to another backend.
    std::uint64_t layout_changes() const { return layout_changes_; }
    std::string take_message() { return std::exchange(message_, {}); }

private:
    std::unique_ptr<Backend> make_backend(ui::BackendChoice choice) const;
    void list_scenes(const WindowOptions& options);
    void load(Scene scene, const Settings& settings, std::uint64_t seed);
    std::size_t add_scene(SceneSource source, ui::SceneChoice choice);
    std::vector<std::pair<Moment, Change>> changes_so_far();
    bool attempt(const std::function<void()>& change);
    bool apply_change(const Change& change);
    void move(const std::function<void()>& motion);
    void start_timeline();
    void look_from(bool behind);

    bool has_compute_;
    bool software_;  // a CPU draws, and would run the stages
    std::shared_ptr<gpu::Programs> programs_;
    std::vector<SceneEntry> gallery_;
    std::vector<SceneSource> sources_;  // of the scenes, one each
    std::vector<ui::SceneChoice> scenes_;
    std::size_t scene_ = 0;
    ui::BackendChoice choice_ = ui::BackendChoice::automatic;
    std::unique_ptr<Simulation> simulation_;
    std::unique_ptr<Stepper> stepper_;
    // Between two substeps: the one that has just run, where the user came forward to here.
    std::optional<Moment> behind_;
    std::uint64_t furthest_step_ = 0;
    Settings wanted_;
    Settings start_;  // with which the run began
    // Changes before the timeline that is remembered now: the backend was changed since.
    std::vector<std::pair<Moment, Change>> earlier_changes_;
    bool both_backends_ = false;
    bool cells_ready_ = false;
    int scene_changes_ = 0;
    std::uint64_t revision_ = 0;
    std::uint64_t layout_changes_ = 0;
    std::string message_;
};

}  // namespace ballpit::app
