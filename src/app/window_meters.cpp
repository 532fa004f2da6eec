#include "app/window_meters.h"

#include "measure/statistics.h"

namespace ballpit::app {

void WindowMeters::restart() {
    balance_.clear();
    series_.clear();
}

void WindowMeters::close() {
    restart();
    times_.clear();
    asked_ = false;
    state_ = {};
}

void WindowMeters::ask(Session& session) {
    Simulation& simulation = session.simulation();
    answer_.reset();
    awaited_.reset();
    if (simulation.metering() && balance_.balance()) {
        answer_ = balance_.last();
    } else if (session.stepper().position().dispatch == 0) {
        const bool metering = simulation.metering();
        simulation.set_metering(true);
        simulation.meter();
        simulation.set_metering(metering);
        awaited_ = simulation.time();
    }
}

// Records of moments before, of another scene perhaps, may still arrive.
void WindowMeters::answer(const MeterRecord& record) {
    if (awaited_ == record.time) {
        awaited_.reset();
        answer_ = record;
    }
}

void WindowMeters::update(Session& session, bool open) {
    Simulation& simulation = session.simulation();
    simulation.set_metering(open);
    if (!open) {
        close();
        for (const MeterRecord& record : awaiting() ? simulation.take_records() : std::vector<MeterRecord>{}) {
            answer(record);
        }
        return;
    }
    // Before anything has run there is something to say, too. Later, the substeps themselves are metered.
    const bool at_start = session.stepper().position() == Position{session.stepper().timeline().start(), 0};
    if (at_start && !asked_) {
        simulation.meter();
    }
    asked_ = at_start;
    for (const MeterRecord& record : simulation.take_records()) {
        series_.add(balance_.add(record));
        answer(record);
    }
    constexpr std::size_t kept_times = 64;
    for (const double ms : simulation.backend().take_reading_times()) {
        times_.push_back(ms);
        if (times_.size() > kept_times) {
            times_.pop_front();
        }
    }
}

const ui::MetersState* WindowMeters::describe(const Session& session, bool open) {
    if (!open) {
        return nullptr;
    }
    state_ = {};
    if (balance_.balance()) {
        state_.record = balance_.last();
        state_.balance = balance_.balance();
        state_.series = series_.points();
        state_.gauges = measure::gauges(*state_.record, session.simulation());
    }
    if (!times_.empty()) {
        state_.ms = measure::median({times_.begin(), times_.end()});
    }
    return &state_;
}

}  // namespace ballpit::app
