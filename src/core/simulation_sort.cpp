// Simulation: which sort stands for SortMethod::automatic.
#include <algorithm>
#include <chrono>
#include <limits>

#include "core/error.h"
#include "core/scene_schedule.h"
#include "core/simulation.h"
#include "core/stopwatch.h"

namespace ballpit {

Schedule Simulation::schedule_for(SortMethod fastest, std::uint32_t ball_count) const {
    Settings settings = run_.settings;
    settings.sort = settings.sort == SortMethod::automatic ? fastest : settings.sort;
    return scene_schedule(settings, run_.scene_box, run_.walls, run_.largest_radius, run_.variety, ball_count);
}

// The quickest of a few times, because whatever else the device does only adds to it. Several builds are run behind one
// another, as in a scene, so that what waiting for the device costs counts little. Infinite where the device has no
// room for what that sort needs.
double Simulation::measured_build_ms(SortMethod sort) {
    constexpr int times = 4;
    constexpr int builds = 4;
    const Schedule schedule = schedule_for(sort, schedule_.ball_count);
    try {
        backend_->reschedule(schedule);
    } catch (const NoRoom&) {
        return std::numeric_limits<double>::infinity();
    }
    const auto collide = std::ranges::find(schedule.dispatches, Stage::collide, &Dispatch::stage);
    const auto last = static_cast<std::size_t>(collide - schedule.dispatches.begin());
    const SubstepParams<double> constants = params();
    double least = std::numeric_limits<double>::infinity();
    for (int time = 0; time <= times; ++time) {  // the first one warms up
        backend_->finish();
        const auto start = std::chrono::steady_clock::now();
        for (int build = 0; build < builds; ++build) {
            backend_->run(schedule, constants, 0, last);
        }
        backend_->finish();
        least = time == 0 ? least : std::min(least, milliseconds_since(start));
    }
    return least;
}

void Simulation::choose_sort() {
    if (run_.settings.sort != SortMethod::automatic || schedule_.key_count == 0 ||
        sort_chosen_for_ == schedule_.ball_count) {
        return;
    }
    const Bytes status = backend_->read(Slot::status);  // what the builds count has happened once, not many times
    const double bitonic = measured_build_ms(SortMethod::bitonic_fused);
    const double counting = measured_build_ms(SortMethod::counting);
    backend_->write(Slot::status, status);
    fastest_sort_ = counting < bitonic ? SortMethod::counting : SortMethod::bitonic_fused;
    sort_chosen_for_ = schedule_.ball_count;
    set_schedule(schedule_.ball_count);
    backend_->reschedule(schedule_);
}

}  // namespace ballpit
