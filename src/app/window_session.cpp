#include "app/window_session.h"

#include <algorithm>
#include <utility>

#include "app/setup.h"
#include "core/error.h"
#include "core/scene_file.h"
#include "core/scene_schedule.h"
#include "gl/error.h"
#include "gpu/gpu_backend.h"

namespace ballpit::app {

namespace {

// Worlds of more balls take longer to build than a frame.
constexpr std::uint32_t quickly_built = 20000;

ui::BackendChoice parse_choice(const std::string& name) {
    const auto& names = ui::backend_choice_names;
    const auto found = std::ranges::find(names, name);
    return found == names.end() ? ui::BackendChoice::automatic : static_cast<ui::BackendChoice>(found - names.begin());
}

bool same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code error;
    return std::filesystem::equivalent(a, b, error) && !error;
}

ui::SceneChoice describe_scene(const std::filesystem::path& file, std::vector<Scene>& readable) {
    try {
        Scene scene = load_scene(file);
        readable.push_back(scene);
        return {std::move(scene.name), std::move(scene.about)};
    } catch (const InputError& error) {
        return {file.stem().string(), error.what()};  // choosing it says so again
    }
}

}  // namespace

Session::Session(const WindowOptions& options, bool has_compute, const std::string& gl_version, bool software)
    : has_compute_(has_compute),
      software_(software),
      programs_(std::make_shared<gpu::Programs>(options.shader_folder)),
      choice_(parse_choice(options.backend)),
      wanted_(options.settings) {
    list_scenes(options);
    start_ = options.settings;
    simulation_ = std::make_unique<Simulation>(options.scene, options.settings, options.seed, make_backend(choice_));
    stepper_ = std::make_unique<Stepper>(*simulation_, default_checkpoint_budget);
    if (choice_ == ui::BackendChoice::automatic && !has_compute) {
        // The driver's text goes on after the number.
        message_ = "No OpenGL 4.3 here, only " + gl_version.substr(0, gl_version.find(' ')) + ": the CPU computes.";
    }
}

void Session::list_scenes(const WindowOptions& options) {
    gallery_ = options.gallery;
    const std::filesystem::path own(options.scene_file);
    const auto entry = std::ranges::find_if(gallery_, [&](const SceneEntry& e) { return same_file(e.path, own); });
    if (entry == gallery_.end()) {
        add_scene({"", own, ""}, {options.scene.name, options.scene.about});
    } else {
        scene_ = static_cast<std::size_t>(entry - gallery_.begin());
    }
    std::vector<Scene> shipped;
    for (const SceneEntry& scene : gallery_) {
        add_scene({scene.name, scene.path, ""}, describe_scene(scene.path, shipped));
    }
    programs_->set_shipped(shipped_programs(shipped));
}

std::size_t Session::add_scene(SceneSource source, ui::SceneChoice choice) {
    sources_.push_back(std::move(source));
    scenes_.push_back(std::move(choice));
    return scenes_.size() - 1;
}

std::unique_ptr<Backend> Session::make_backend(ui::BackendChoice choice) const {
    if (choice == ui::BackendChoice::automatic) {
        choice = has_compute_ && !software_ ? ui::BackendChoice::gpu : ui::BackendChoice::threads;
    }
    if (choice == ui::BackendChoice::gpu) {
        return std::make_unique<gpu::GpuBackend>(programs_);
    }
    return make_cpu_backend(ui::backend_choice_names[static_cast<std::size_t>(choice)]);
}

std::unique_ptr<Backend> Session::twin_backend() const {
    return make_backend(parse_choice(std::string(simulation_->backend().name())));
}

// A refused file or value leaves the simulation as it was, and so does a device without room. One that failed has lost
// its balls: then the scene that ran starts anew, with the settings that it ran with.
bool Session::attempt(const std::function<void()>& change) {
    const Scene scene = simulation_->scene();
    const Settings settings = simulation_->settings();
    const std::uint64_t seed = simulation_->seed();
    const auto restore = [&](const std::exception& error) {
        message_ = std::string(error.what()) + " The scene starts anew.";
        load(scene, settings, seed);
    };
    cells_ready_ = false;
    ++revision_;
    ++layout_changes_;
    bool done = false;
    try {
        change();
        done = true;
    } catch (const InputError& error) {
        message_ = error.what();
    } catch (const NoRoom& error) {
        message_ = std::string(error.what()) + ". The scene runs on as it was.";
    } catch (const DeviceError& error) {
        restore(error);
    } catch (const gl::Error& error) {
        restore(error);
    }
    wanted_ = simulation_->settings();
    return done;
}

void Session::load(Scene scene, const Settings& settings, std::uint64_t seed) {
    simulation_->load(std::move(scene), settings, seed);
    earlier_changes_.clear();
    both_backends_ = false;
    start_timeline();
    start_ = simulation_->settings();
}

void Session::start_timeline() {
    stepper_->reset();
    behind_.reset();
    furthest_step_ = simulation_->step_count();
}

void Session::restart(bool new_seed) {
    attempt([&] {
        simulation_->restart(simulation_->seed() + (new_seed ? 1 : 0));
        earlier_changes_.clear();
        both_backends_ = false;
        start_timeline();
        start_ = simulation_->settings();
    });
}

void Session::choose_scene(std::size_t index) {
    const bool done = attempt([&] {
        const SceneSource& source = sources_[index];
        Scene scene = source.file.empty() ? parse_scene(source.text, "the share code's scene")
                                          : load_scene(source.file);  // read again: it may have been edited
        const ui::SceneChoice choice{scene.name, scene.about};
        const Settings settings = scene.settings;
        const std::uint64_t seed = scene.fill ? scene.fill->seed : 0;
        load(std::move(scene), settings, seed);
        scenes_[index] = choice;
    });
    if (done) {
        scene_ = index;
        ++scene_changes_;
    }
}

// A scene that is refused is passed over, and its sentence stays on screen: else no key would lead past it.
void Session::next_scene(int offset) {
    const auto count = static_cast<int>(scenes_.size());
    const int changes = scene_changes_;
    int index = static_cast<int>(scene_);
    for (int tried = 1; tried < count && scene_changes_ == changes; ++tried) {
        index = (index + offset + count) % count;
        choose_scene(static_cast<std::size_t>(index));
    }
}

void Session::choose_backend(ui::BackendChoice choice) {
    const auto change = [&] {
        std::unique_ptr<Backend> backend = make_backend(choice);
        auto changes = changes_so_far();
        // Mirror and threads have the same bits.
        both_backends_ = both_backends_ || (backend->name() == "gpu") != (simulation_->backend().name() == "gpu");
        simulation_->use(std::move(backend));
        earlier_changes_ = std::move(changes);
        start_timeline();
    };
    if (attempt(change)) {
        choice_ = choice;
    }
}

void Session::clear_status() {
    const Status clean{};
    simulation_->backend().write(Slot::status, std::as_bytes(std::span(&clean, 1)));
    ++revision_;
}

void Session::apply(bool held) {
    const Settings& current = simulation_->settings();
    if (wanted_ == current) {
        return;
    }
    const bool slow = wanted_.balls != current.balls && std::max(wanted_.balls, current.balls) > quickly_built;
    if (!(held && slow)) {
        apply_change(Settings(wanted_));
    }
}

bool Session::add_balls(std::vector<BallSpec> balls) {
    apply(false);
    return apply_change(AddBalls{std::move(balls)});
}

bool Session::relax() {
    apply(false);
    return apply_change(Relax{});
}

bool Session::apply_change(const Change& change) {
    return attempt([&] {
        stepper_->change(change);
        behind_.reset();
        furthest_step_ = simulation_->step_count();  // what lay ahead will be another run
    });
}

void Session::prepare_cells() {
    const Schedule& schedule = simulation_->schedule();
    if (cells_ready_ || schedule.cell_count == 0 || stepper_->position().dispatch > 0) {
        return;
    }
    Backend& backend = simulation_->backend();
    const Bytes status = backend.read(Slot::status);
    // The one that leaves both the keys sorted and the cells' ranges.
    const auto built = std::ranges::find_if(schedule.dispatches, [](const Dispatch& d) {
        return d.program.shader == Shader::build_grid || d.program.shader == Shader::order_keys;
    });
    if (built == schedule.dispatches.end()) {
        return;  // the grid that is there is the one that will be used
    }
    backend.run(schedule, simulation_->params(), 0, static_cast<std::size_t>(built - schedule.dispatches.begin()) + 1);
    backend.write(Slot::status, status);  // looking is no substep: what it counted does not count
    cells_ready_ = true;
    ++revision_;
}

void Session::describe(ui::State& state) const {
    const Simulation& simulation = *simulation_;
    state.scenes = scenes_;
    state.scene = scene_;
    state.time = simulation.time();
    state.step_count = simulation.step_count();
    state.seed = simulation.seed();
    state.settings = wanted_;
    state.defaults = simulation.scene().settings;
    state.features = simulation.features();
    state.variety = simulation.variety();
    state.own_restitutions = std::ranges::any_of(simulation.scene().balls,
                                                 [](const BallSpec& ball) { return ball.restitution.has_value(); });
    state.most_balls = simulation.scene().fill ? maximum_balls
                                               : std::max(static_cast<std::uint32_t>(simulation.scene().balls.size()),
                                                          simulation.settings().balls);
    state.overlapping = simulation.overlapping_at_start();
    state.backend = choice_;
    state.gpu_usable = has_compute_;
    state.software = software_;
    state.backend_name = simulation.backend().name();
    state.has_grid = simulation.schedule().cell_count > 0;
    state.cell_width = simulation.schedule().grid.cell_width;
    state.largest_radius = simulation.largest_ball_radius();
}

}  // namespace ballpit::app
