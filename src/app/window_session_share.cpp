// What of a session is kept and shared: a code of its run and back, scene files from elsewhere, what comes back
// tomorrow.
#include <algorithm>
#include <exception>
#include <utility>

#include "app/atomic_file.h"
#include "app/user_settings.h"
#include "app/window_session.h"
#include "core/error.h"
#include "core/scene_file.h"

namespace ballpit::app {

void Session::open_file(const std::filesystem::path& file) {
    std::error_code error;
    const std::filesystem::path full = std::filesystem::absolute(file, error);
    const auto known = std::ranges::find_if(sources_, [&](const SceneSource& source) { return source.file == full; });
    const std::size_t count = sources_.size();
    const std::size_t index = known != sources_.end() ? static_cast<std::size_t>(known - sources_.begin())
                                                      : add_scene({"", full, ""}, {full.stem().string(), ""});
    const int before = scene_changes_;
    choose_scene(index);
    if (scene_changes_ == before && index == count) {  // refused: it is none
        sources_.pop_back();
        scenes_.pop_back();
    }
}

// What lies ahead of where one has stepped back to has not happened.
std::vector<std::pair<Moment, Change>> Session::changes_so_far() {
    std::vector<std::pair<Moment, Change>> changes = earlier_changes_;
    const Moment now = stepper_->position().moment;
    for (const auto& [at, list] : stepper_->timeline().changes()) {
        for (const Change& change : list) {
            if (at <= now) {
                changes.emplace_back(at, change);
            }
        }
    }
    return changes;
}

void Session::describe(SharedCode& code) {
    const SceneSource& source = sources_[scene_];
    const Scene& scene = simulation_->scene();
    code.scene = source.name;
    code.scene_text = source.name.empty() ? scene_text(scene) : "";
    code.scene_check = scene_check(scene);
    code.seed = simulation_->seed();
    code.start = setting_differences(scene.settings, start_);
    code.changes = shared_changes(start_, changes_so_far());
    const ui::Place shown = place();
    code.substep = shown.substep;
    code.ran = shown.ran;
    code.hash = awaited_hash(*stepper_, *simulation_);
    code.backend = both_backends_ ? "both" : std::string(simulation_->backend().name());
    code.device = simulation_->backend().device();
}

bool Session::open(const SharedCode& code) {
    std::size_t index = scenes_.size();
    const bool done = attempt([&] {
        SharedScene shared = shared_scene(code, gallery_);
        const ui::SceneChoice choice{shared.scene.name, shared.scene.about};
        load(std::move(shared.scene), shared.settings, code.seed);
        const auto known = std::ranges::find_if(sources_, [&](const SceneSource& source) {
            return source.name == code.scene && source.text == code.scene_text &&
                   (!code.scene.empty() || source.file.empty());
        });
        index = known != sources_.end() ? static_cast<std::size_t>(known - sources_.begin())
                                        : add_scene({code.scene, "", code.scene_text}, choice);
        if (!shared.same) {
            message_ = "The code was made with another scene '" + code.scene + "' than the one here.";
        }
    });
    if (done) {
        scene_ = index;
        ++scene_changes_;
    }
    return done;
}

bool Session::replay(Replay& replay, double seconds) {
    bool ended = true;
    try {
        ended = replay.advance(*stepper_, *simulation_, seconds);
    } catch (const std::exception&) {
        const std::exception_ptr failure = std::current_exception();
        attempt([&] { std::rethrow_exception(failure); });  // says what it was, and brings lost balls back
    }
    const Position now = stepper_->position();
    wanted_ = simulation_->settings();
    ++revision_;
    ++layout_changes_;
    furthest_step_ = std::max(furthest_step_, now.moment.step);
    cells_ready_ = now != Position{stepper_->timeline().start(), 0};
    look_from(ended && now.moment > replay.goal());
    return ended;
}

std::string Session::rescue(const std::filesystem::path& folder) const {
    try {
        const std::filesystem::path place = folder / "before_reset.json";
        std::error_code ignored;  // what is wrong with it, writing tells
        std::filesystem::create_directories(folder, ignored);
        AtomicFile file(place);
        file.stream() << scene_text(scene_as_set(*simulation_));
        file.commit();
        return "Settings are kept, and the scene as it was set is in " + place.string();
    } catch (const InputError& error) {
        return std::string("The scene could not be saved: ") + error.what();
    }
}

std::string Session::scene_stem() const {
    const SceneSource& source = sources_[scene_];
    if (!source.name.empty()) {
        return source.name;
    }
    return source.file.empty() ? simulation_->scene().name : source.file.stem().string();
}

void Session::describe(UserSettings& user) const {
    const SceneSource& source = sources_[scene_];
    const Scene& scene = simulation_->scene();
    Settings settings = simulation_->settings();
    settings.balls -= simulation_->added();  // thrown in, they do not come back
    settings.pull.reset();
    user.scene = source.name.empty() ? source.file.string() : source.name;
    user.changed.clear();
    for (const auto& [key, text] : setting_differences(scene.settings, settings)) {
        user.changed.emplace(key, text);
    }
    const std::uint64_t own_seed = scene.fill ? scene.fill->seed : 0;
    user.seed = simulation_->seed() == own_seed ? std::nullopt : std::optional(simulation_->seed());
    user.backend = ui::backend_choice_names[static_cast<std::size_t>(choice_)];
}

}  // namespace ballpit::app
