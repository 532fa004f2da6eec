#include "core/simulation.h"

#include <algorithm>
#include <cassert>
#include <span>
#include <utility>

#include "core/quarantine.h"
#include "core/scene_schedule.h"

namespace ballpit {

Simulation::Simulation(Scene scene, const Settings& settings, std::uint64_t seed, std::unique_ptr<Backend> backend)
    : backend_(std::move(backend)) {
    load(std::move(scene), settings, seed);
}

void Simulation::all_or_nothing(const std::function<void()>& action) {
    const RunState run = run_;
    const Schedule schedule = schedule_;
    const std::uint64_t seed = seed_;
    try {
        action();
    } catch (...) {
        run_ = run;
        schedule_ = schedule;
        derive_schedules();
        seed_ = seed;
        throw;
    }
}

void Simulation::load(Scene scene, const Settings& settings, std::uint64_t seed) {
    World world = make_world(scene, settings.balls, seed);
    const WallShift walls = scene.resume ? scene.resume->walls : WallShift{};
    expect_storage(scene_schedule(settings, world.box, walls, largest_radius(world.balls), variety_of(world.balls),
                                  settings.balls),
                   backend_->storage_limits());
    std::swap(scene_, scene);
    all_or_nothing([&] {
        try {
            run_.settings = settings;
            seed_ = seed;
            load_world(std::move(world));
        } catch (...) {
            std::swap(scene_, scene);
            throw;
        }
    });
}

// Balls that were thrown in do not come back.
void Simulation::restart(std::uint64_t seed) {
    World world = make_world(scene_, run_.settings.balls - run_.added, seed);
    all_or_nothing([&] {
        run_.settings.balls -= run_.added;
        seed_ = seed;
        load_world(std::move(world));
    });
}

// A saved moment goes on where it was; any other world starts at 0.
void Simulation::load_world(World world) {
    const Resume from = scene_.resume.value_or(Resume{});
    run_.scene_box = world.box;
    run_.walls = from.walls;
    run_.overlapping = world.overlapping;
    run_.added = 0;
    run_.step_count = from.step;
    run_.substep = from.substep;
    run_.substeps_since_base = 0;
    run_.time_base = from.time;
    world.balls.velocity_lag = from.velocity_lag;
    load_state(std::move(world.balls));
    interrupt_meters();
}

void Simulation::load_state(BallState state) {
    Status status{};
    run_.settings.laws.diagnostics ? quarantine(state, run_.scene_box, status) : release(state);
    run_.restitutions = ball_restitutions(scene_, run_.settings, state.count());
    run_.velocity_lag = state.velocity_lag;
    run_.largest_radius = largest_radius(state);
    run_.variety = variety_of({state.positions, state.velocities, run_.restitutions, run_.velocity_lag, {}});
    set_schedule(state.count());
    load_backend(*backend_,
                 {state.positions, state.velocities, run_.restitutions, run_.velocity_lag, state.compensations});
    choose_sort();
    add_to_status(status);
}

void Simulation::add_to_status(const Status& more) {
    if (more.bits != 0) {
        const Status sum = sum_of(read_slot<Status>(*backend_, Slot::status).front(), more);
        backend_->write(Slot::status, std::as_bytes(std::span(&sum, 1)));
    }
}

// Restitutions that no law asks for are remembered here, but not on the device.
void Simulation::load_backend(Backend& backend, BallState state) const {
    if (!schedule_.features.has(Feature::ball_restitution)) {
        state.restitutions.clear();
    }
    backend.load(state, schedule_, run_.settings.limit_force);
}

Features Simulation::wanted_features(const Settings& settings) const {
    return features_of(settings, run_.variety, ballpit::walls_move(run_.walls, settings, run_.scene_box, wall_room()));
}

void Simulation::set_schedule(std::uint32_t ball_count) {
    schedule_ = schedule_for(fastest_sort_, ball_count);
    derive_schedules();
    run_.grid_age = 0;
}

void Simulation::derive_schedules() {
    reused_schedule_ = with_grid_reused(schedule_);
    kept_schedule_ = can_keep_order(schedule_) ? keeping_order(schedule_) : schedule_;
    kept_reused_schedule_ = with_grid_reused(kept_schedule_);
    ++schedule_changes_;
}

// Meters read the state of the substep's start beside the one of its end, both in the order of ball ids.
const Schedule& Simulation::whole_schedule() const {
    if (!backend_->keeps_order() || metering_ || (!builds_grid() && !backend_->is_in_order())) {
        return schedule();
    }
    return builds_grid() ? kept_schedule_ : kept_reused_schedule_;
}

Walls Simulation::walls(const Settings& settings) const {
    const double dt = substep_dt(settings);
    return ballpit::walls_move(run_.walls, settings, run_.scene_box, wall_room())
               ? moving_walls(run_.scene_box, run_.walls,
                              advance(run_.walls, settings, run_.scene_box, wall_room(), dt), dt)
               : Walls(box());
}

SubstepParams<double> Simulation::params() const { return params_for(run_.settings, schedule_, run_.variety); }

SubstepParams<double> Simulation::params_for(const Settings& settings, const Schedule& schedule,
                                             const Variety& variety) const {
    const SubstepMotion motion =
        substep_motion(settings.integrator, drag(settings), substep_dt(settings), run_.velocity_lag);
    return make_substep_params(settings, walls(settings), schedule.grid, motion, schedule.ball_count, variety);
}

Plan Simulation::plan(const Settings& settings) const {
    assert(settings.balls == run_.settings.balls);
    Plan plan;
    plan.restitutions = ball_restitutions(scene_, settings, settings.balls);
    Variety variety = run_.variety;
    variety.restitutions = !plan.restitutions.empty();
    plan.schedule = scene_schedule(settings, run_.scene_box, run_.walls, run_.largest_radius, variety, settings.balls);
    plan.params = params_for(settings, plan.schedule, variety);
    if (!plan.schedule.features.has(Feature::ball_restitution)) {
        plan.restitutions.clear();  // no law asks for them
    }
    return plan;
}

void Simulation::advance_walls() {
    if (!walls_move()) {
        return;
    }
    run_.walls = advance(run_.walls, run_.settings, run_.scene_box, wall_room(), substep_dt(run_.settings));
    if (!walls_move()) {  // arrived: from here on their velocity is not asked for
        set_schedule(schedule_.ball_count);
        backend_->reschedule(schedule_);
    }
}

void Simulation::begin_substep() {
    if (metering_ && !metered_ && schedule_.in_place) {
        request_reading();
    }
}

void Simulation::end_substep(const Schedule& ran) {
    if (metering_ && !metered_ && !schedule_.in_place) {
        request_reading();
    }
    metered_ = false;
    if (ran.swaps_states && !still()) {
        backend_->swap_states();
    }
    run_.velocity_lag =
        substep_motion(run_.settings.integrator, drag(run_.settings), substep_dt(run_.settings), run_.velocity_lag)
            .lag_after;
    age_grid();
    advance_walls();
    ++run_.substeps_since_base;
    ++run_.substep;
    if (run_.substep >= run_.settings.substeps) {  // more than, where the number was lowered within the step
        run_.substep = 0;
        run_.grid_age = 0;
        ++run_.step_count;
    }
}

void Simulation::age_grid() {
    if (schedule_.key_count > 0) {
        run_.grid_age = (run_.grid_age + 1) % run_.settings.grid_reuse;
    }
}

// A step of no time leaves every bit as it is: -0 would not outlive the addition of 0.
bool Simulation::still() const {
    const SubstepMotion motion =
        substep_motion(run_.settings.integrator, drag(run_.settings), substep_dt(run_.settings), run_.velocity_lag);
    return motion.drift == 0.0 && motion.first.gain == 0.0 && motion.second.gain == 0.0;
}

void Simulation::substep(bool watched) {
    begin_substep();
    const Schedule& runs = watched ? schedule() : whole_schedule();
    if (!still() || (metering_ && !schedule_.in_place)) {
        backend_->run(runs, params(), 0, runs.dispatches.size());
    }
    end_substep(runs);
}

void Simulation::step() {
    const std::uint64_t next = run_.step_count + 1;
    while (run_.step_count < next) {
        substep();
    }
}

Checkpoint Simulation::checkpoint() {
    Checkpoint checkpoint{backend_->save(), run_};
    checkpoint.run.grid_age = 0;  // keys and cells are not kept
    return checkpoint;
}

void Simulation::restore(const Checkpoint& checkpoint) {
    run_ = checkpoint.run;
    set_schedule(checkpoint.state->ball_count());
    backend_->restore(*checkpoint.state, schedule_);
    interrupt_meters();
}

double Simulation::time() const {
    return run_.time_base + static_cast<double>(run_.substeps_since_base) * substep_dt(run_.settings);
}

void Simulation::rebase_clock() {
    run_.time_base = time();
    run_.substeps_since_base = 0;
}

BallState Simulation::raw_state() {
    return {read_slot<vec4>(*backend_, Slot::positions), read_slot<vec4>(*backend_, Slot::velocities),
            run_.restitutions, run_.velocity_lag, read_slot<Compensation>(*backend_, Slot::compensations)};
}

BallState Simulation::synchronised_state() {
    BallState state = raw_state();
    if (run_.velocity_lag == 0.0 || schedule_.dispatches.empty()) {
        return state;
    }
    const auto params = make_substep_params(run_.settings, walls(run_.settings), schedule_.grid,
                                            synchronising_motion(drag(run_.settings), run_.velocity_lag),
                                            schedule_.ball_count, run_.variety);
    run_aside(params, [&] {  // a kick without a drift: not a substep
        state.velocities = read_slot<vec4>(*backend_, schedule_.in_place ? Slot::velocities : Slot::next_velocities);
        state.compensations = read_slot<Compensation>(*backend_, Slot::compensations);
    });
    state.velocity_lag = 0.0;
    return state;
}

void Simulation::run_aside(const SubstepParams<double>& params, const std::function<void()>& look) {
    const auto before = schedule_.in_place ? backend_->save() : nullptr;
    const Bytes status = backend_->read(Slot::status);
    const Bytes compensations = backend_->read(Slot::compensations);
    const Bytes built_positions = backend_->read(Slot::built_positions);
    backend_->run(schedule(), params, 0, schedule().dispatches.size());
    look();
    if (before != nullptr) {
        backend_->restore(*before, schedule_);
    } else {
        backend_->write(Slot::status, status);  // what was counted and left out aside does not count
        backend_->write(Slot::compensations, compensations);
        backend_->write(Slot::built_positions, built_positions);
    }
}

}  // namespace ballpit
