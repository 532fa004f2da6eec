#include "app/shared_run.h"

#include <algorithm>
#include <chrono>

#include "core/error.h"
#include "core/scene_file.h"

namespace ballpit::app {

namespace {

Scene scene_of(const SharedCode& code, std::span<const SceneEntry> gallery) {
    if (code.scene.empty()) {
        return parse_scene(code.scene_text, "the share code's scene");
    }
    // Only by name: a code must not open any file that it likes.
    const auto entry = std::ranges::find(gallery, code.scene, &SceneEntry::name);
    if (entry == gallery.end()) {
        throw InputError("the share code: expected a scene of this gallery, found '" + code.scene.substr(0, 60) + "'");
    }
    return load_scene(entry->path);
}

void apply(const SharedChange& change, Stepper& stepper, Simulation& simulation) {
    awaited_hash(stepper, simulation);  // asked for on arriving here: a change would make it another timeline's
    if (!change.balls.empty()) {
        stepper.change(AddBalls{change.balls});
        return;
    }
    if (change.relax) {
        stepper.change(Relax{});
        return;
    }
    Settings settings = simulation.settings();
    assign_settings(settings, change.settings);
    stepper.change(settings);
}

}  // namespace

SharedScene shared_scene(const SharedCode& code, std::span<const SceneEntry> gallery) {
    SharedScene shared;
    shared.scene = scene_of(code, gallery);
    shared.settings = shared.scene.settings;
    assign_settings(shared.settings, code.start);
    shared.same = code.scene.empty() || scene_check(shared.scene) == code.scene_check;
    return shared;
}

bool Replay::advance(Stepper& stepper, Simulation& simulation, double seconds) {
    using SteadyClock = std::chrono::steady_clock;
    if (substep_ < stepper.timeline().start()) {
        throw InputError("the share code: its moment lies before the start of its scene");
    }
    const auto end = SteadyClock::now() + std::chrono::duration<double>(seconds);
    do {
        const Moment now = stepper.position().moment;
        if (next_ < changes_.size() && changes_[next_].at <= now) {
            apply(changes_[next_], stepper, simulation);
            ++next_;
        } else if (now >= substep_) {
            stepper.go_to({substep_, ran_});
            return true;
        } else {
            const Moment stop = next_ < changes_.size() ? std::min(changes_[next_].at, substep_) : substep_;
            stepper.go_to({std::min(stop, Moment{now.step + 1, 0}), 0});
            simulation.backend().finish();  // else a slice would only be a queue that grows
        }
    } while (SteadyClock::now() < end);
    return false;
}

std::optional<std::uint64_t> awaited_hash(Stepper& stepper, Simulation& simulation) {
    constexpr int looks = 4;  // the first may only start the copy, the second have an older one
    for (int i = 0; i < looks && !stepper.hash(simulation.step_count()); ++i) {
        simulation.backend().finish();
        stepper.update();
    }
    return stepper.hash(simulation.step_count());
}

}  // namespace ballpit::app
