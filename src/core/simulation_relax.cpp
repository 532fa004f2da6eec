// What Simulation does to push balls that overlap apart.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/scene_schedule.h"
#include "core/simulation.h"

namespace ballpit {

namespace {

constexpr int substeps_a_round = 32;
constexpr int most_rounds = 200;
constexpr double gone = 1e-6;       // of the energy at the start
constexpr double standstill = 0.9;  // of the round before: what is left has no room

// Springs and walls alone, in a medium so thick that every spring creeps back without swinging.
Settings thickened(const Settings& settings, double omega) {
    Settings calm = settings;
    calm.laws.gravity = calm.laws.shake = false;
    calm.laws.restitution = calm.laws.ball_restitution = false;
    calm.laws.drag = true;
    calm.pull.reset();
    calm.integrator = Integrator::symplectic_euler;
    calm.substeps = 1;
    calm.grid_reuse = 1;
    calm.dt = 0.5 / omega;  // a quarter of what is stable
    calm.drag = omega;
    return calm;
}

}  // namespace

// The stiffest mode is metered anew in every round, because it goes down as balls part.
void Simulation::relax() {
    const Laws& laws = run_.settings.laws;
    const double omega_squared = run_.settings.stiffness / run_.variety.lightest_mass;
    if ((!laws.contact && !laws.walls) || !(omega_squared > 0.0)) {
        return;
    }
    BallState state = synchronised_state();
    const std::vector<vec4> velocities = state.velocities;
    for (vec4& velocity : state.velocities) {
        velocity = vec4(vec3(0.0f), velocity.w);
    }
    const Status counted = read_slot<Status>(*backend_, Slot::status).front();
    rebase_clock();
    interrupt_meters();
    meter_queue_.clear();
    Variety variety = run_.variety;
    variety.restitutions = false;
    state.restitutions.clear();
    state.velocity_lag = 0.0;
    double omega = std::sqrt(8.0 * omega_squared);
    double first = 0.0;
    double before = std::numeric_limits<double>::infinity();
    for (int round = 0; round < most_rounds; ++round) {
        const Settings calm = thickened(run_.settings, omega);
        const Schedule schedule =
            scene_schedule(calm, run_.scene_box, run_.walls, run_.largest_radius, variety, schedule_.ball_count);
        if (round == 0) {
            backend_->load(state, schedule, calm.limit_force);
        }
        const MeterReading reading = run_round(calm, schedule, variety);
        first = std::max(first, reading.elastic);
        if (reading.elastic <= gone * first || (round > 0 && reading.elastic > standstill * before)) {
            break;
        }
        before = reading.elastic;
        omega = std::sqrt(std::max(reading.max_stiffness, omega_squared));
    }
    state.positions = read_slot<vec4>(*backend_, Slot::positions);
    state.compensations = read_slot<Compensation>(*backend_, Slot::compensations);
    state.velocities = velocities;
    load_state(std::move(state));
    add_to_status(counted);
}

// What the springs hold at the start of the round.
MeterReading Simulation::run_round(const Settings& calm, const Schedule& schedule, const Variety& variety) {
    const SubstepMotion motion = substep_motion(calm.integrator, calm.drag, calm.dt, 0.0);
    const auto params = make_substep_params(calm, Walls(box()), schedule.grid, motion, schedule.ball_count, variety);
    const auto read = [&] {
        backend_->finish();
        backend_->take_readings();
        backend_->request_reading(0, schedule, params, Synchronisation{});
    };
    for (int i = 0; i < substeps_a_round; ++i) {
        if (i == 0 && schedule.in_place) {
            read();
        }
        backend_->run(schedule, params, 0, schedule.dispatches.size());
        if (!schedule.in_place) {
            if (i == 0) {
                read();
            }
            backend_->swap_states();
        }
    }
    std::vector<TaggedReading> readings = backend_->take_readings();
    while (readings.empty() && schedule.ball_count > 0) {
        backend_->finish();
        readings = backend_->take_readings();
    }
    return readings.empty() ? MeterReading{} : readings.back().reading;
}

}  // namespace ballpit
