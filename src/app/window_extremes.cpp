#include "app/window_extremes.h"

#include "measure/warnings.h"

namespace ballpit::app {

void WindowExtremes::describe(Session& session, Clock& clock, const MeterRecord* record, ui::State& state) {
    constexpr std::uint32_t quickly_searched = 100000;  // balls; more take longer than a frame
    Simulation& simulation = session.simulation();
    if (scene_changes_ != session.scene_changes()) {
        scene_changes_ = session.scene_changes();
        hidden_ = {};
        clock.forget_hitches();
    }
    const bool at_start = session.stepper().position() == Position{session.stepper().timeline().start(), 0};
    if (at_start && looked_at_ != session.revision()) {
        looked_at_ = session.revision();
        stored_ = simulation.schedule().ball_count > quickly_searched
                      ? 0.0
                      : measure::stored_in_overlaps(simulation.raw_state(), simulation.settings(),
                                                    simulation.features(), simulation.box());
    }
    shown_ = measure::worse_of(counted_extremes(state.status), measure::warnings_of(simulation, record));
    shown_[Extreme::hitches] = clock.hitches();
    shown_[Extreme::initial_overlap] = stored_;
    state.extremes = shown_;
    for (std::size_t i = 0; i < extreme_count; ++i) {
        state.extremes.numbers[i] = hidden_[i] ? 0.0 : shown_.numbers[i];
    }
}

void WindowExtremes::hide() {
    for (const ExtremeInfo& info : extreme_table()) {
        const bool alarm = info.counted && info.extreme != Extreme::hitches;
        hidden_[static_cast<std::size_t>(info.extreme)] |= !alarm && shown_[info.extreme] != 0.0;
    }
}

}  // namespace ballpit::app
