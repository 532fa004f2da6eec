// What Simulation does for its meters (meter.h).
#include <cassert>

#include "core/simulation.h"

namespace ballpit {

namespace {

// What is stored in springs and heights changes at one blow, or another integrator answers for what comes.
bool moves_energy(const Settings& from, const Settings& to) {
    return from.balls != to.balls || from.laws != to.laws || from.gravity != to.gravity ||
           from.stiffness != to.stiffness || from.integrator != to.integrator;
}

}  // namespace

void Simulation::set_metering(bool on) {
    if (on != metering_) {
        metering_ = on;
        interrupt_meters();
    }
}

void Simulation::interrupt_meters() {
    ++meter_run_;
    metered_ = false;
}

void Simulation::interrupt_meters(const Settings& wanted) {
    metered_ = false;
    meter_run_ += moves_energy(settings(), wanted) ? 1 : 0;
}

void Simulation::request_reading() {
    const double lag = velocity_lag();
    const SubstepMotion motion = substep_motion(settings().integrator, drag(settings()), substep_dt(settings()), lag);
    MeterRecord moment;
    moment.step = step_count();
    moment.substep = substep_in_step();
    moment.time = time();
    moment.dt = substep_dt(settings());
    moment.drag = drag(settings());
    moment.gravity = settings().laws.gravity ? settings().gravity : dvec3(0.0);
    moment.run = meter_run_;
    backend_->request_reading(meter_queue_.add(moment), schedule_, params(),
                              synchronisation_of(motion, moment.drag, lag, schedule_.in_place));
    metered_ = true;
}

void Simulation::meter() {
    assert(metering_);
    if (metered_) {
        return;
    }
    if (schedule_.in_place) {
        request_reading();
    } else {
        run_aside(params(), [this] { request_reading(); });
    }
}

std::vector<MeterRecord> Simulation::take_records() { return meter_queue_.match(backend_->take_readings()); }

}  // namespace ballpit
