#include "core/simulation.h"

#include <algorithm>
#include <cassert>
#include <span>
#include <string>
#include <utility>

#include "core/error.h"
#include "core/scene_schedule.h"

namespace ballpit {

Simulation::Simulation(Scene scene, const Settings& settings, std::uint64_t seed, std::unique_ptr<Backend> backend)
    : backend_(std::move(backend)) {
    load(std::move(scene), settings, seed);
}

void Simulation::load(Scene scene, const Settings& settings, std::uint64_t seed) {
    World world = make_world(scene, settings.balls, seed);
    scene_ = std::move(scene);
    settings_ = settings;
    seed_ = seed;
    load_world(std::move(world));
}

// Balls that were thrown in do not come back.
void Simulation::restart(std::uint64_t seed) {
    World world = make_world(scene_, settings_.balls - added_, seed);
    settings_.balls -= added_;
    seed_ = seed;
    load_world(std::move(world));
}

// A saved moment goes on where it was; any other world starts at 0.
void Simulation::load_world(World world) {
    const Resume from = scene_.resume.value_or(Resume{});
    scene_box_ = world.box;
    walls_ = from.walls;
    overlapping_ = world.overlapping;
    added_ = 0;
    step_count_ = from.step;
    substep_ = from.substep;
    substeps_since_base_ = 0;
    time_base_ = from.time;
    world.balls.velocity_lag = from.velocity_lag;
    load_state(world.balls);
}

void Simulation::load_state(const BallState& state) {
    restitutions_ = ball_restitutions(scene_, settings_, state.count());
    velocity_lag_ = state.velocity_lag;
    largest_radius_ = largest_radius(state);
    variety_ = variety_of({state.positions, state.velocities, restitutions_, velocity_lag_});
    set_schedule(state.count());
    load_backend(*backend_, {state.positions, state.velocities, restitutions_, velocity_lag_});
}

// Restitutions that no law asks for are remembered here, but not on the device.
void Simulation::load_backend(Backend& backend, BallState state) const {
    if (!schedule_.features.has(Feature::ball_restitution)) {
        state.restitutions.clear();
    }
    backend.load(state, schedule_, settings_.limit_force);
}

Features Simulation::wanted_features(const Settings& settings) const {
    return features_of(settings, variety_, ballpit::walls_move(walls_, settings, scene_box_, wall_room()));
}

void Simulation::set_schedule(std::uint32_t ball_count) {
    schedule_ = scene_schedule(settings_, scene_box_, walls_, largest_radius_, variety_, ball_count);
    ++schedule_changes_;
}

Walls Simulation::walls(const Settings& settings) const {
    const double dt = substep_dt(settings);
    return ballpit::walls_move(walls_, settings, scene_box_, wall_room())
               ? moving_walls(scene_box_, walls_, advance(walls_, settings, scene_box_, wall_room(), dt), dt)
               : Walls(box());
}

SubstepParams<double> Simulation::params() const { return params_for(settings_, schedule_, variety_); }

SubstepParams<double> Simulation::params_for(const Settings& settings, const Schedule& schedule,
                                             const Variety& variety) const {
    const SubstepMotion motion =
        substep_motion(settings.integrator, drag(settings), substep_dt(settings), velocity_lag_);
    return make_substep_params(settings, walls(settings), schedule.grid, motion, schedule.ball_count, variety);
}

Plan Simulation::plan(const Settings& settings) const {
    assert(settings.balls == settings_.balls);
    Plan plan;
    plan.restitutions = ball_restitutions(scene_, settings, settings.balls);
    Variety variety = variety_;
    variety.restitutions = !plan.restitutions.empty();
    plan.schedule = scene_schedule(settings, scene_box_, walls_, largest_radius_, variety, settings.balls);
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
    walls_ = advance(walls_, settings_, scene_box_, wall_room(), substep_dt(settings_));
    if (!walls_move()) {  // arrived: from here on their velocity is not asked for
        set_schedule(schedule_.ball_count);
        backend_->reschedule(schedule_);
    }
}

void Simulation::end_substep() {
    if (!schedule_.in_place) {
        backend_->swap_states();
    }
    velocity_lag_ =
        substep_motion(settings_.integrator, drag(settings_), substep_dt(settings_), velocity_lag_).lag_after;
    advance_walls();
    ++substeps_since_base_;
    ++substep_;
    if (substep_ >= settings_.substeps) {  // more than, where the number was lowered within the step
        substep_ = 0;
        ++step_count_;
    }
}

void Simulation::substep() {
    backend_->run(schedule_, params(), 0, schedule_.dispatches.size());
    end_substep();
}

void Simulation::step() {
    const std::uint64_t next = step_count_ + 1;
    while (step_count_ < next) {
        substep();
    }
}

Checkpoint Simulation::checkpoint() {
    Checkpoint checkpoint;
    checkpoint.state = backend_->save();
    checkpoint.settings = settings_;
    checkpoint.scene_box = scene_box_;
    checkpoint.walls = walls_;
    checkpoint.largest_radius = largest_radius_;
    checkpoint.variety = variety_;
    checkpoint.velocity_lag = velocity_lag_;
    checkpoint.restitutions = restitutions_;
    checkpoint.overlapping = overlapping_;
    checkpoint.added = added_;
    checkpoint.step_count = step_count_;
    checkpoint.substep = substep_;
    checkpoint.substeps_since_base = substeps_since_base_;
    checkpoint.time_base = time_base_;
    return checkpoint;
}

void Simulation::restore(const Checkpoint& checkpoint) {
    settings_ = checkpoint.settings;
    scene_box_ = checkpoint.scene_box;
    walls_ = checkpoint.walls;
    largest_radius_ = checkpoint.largest_radius;
    variety_ = checkpoint.variety;
    velocity_lag_ = checkpoint.velocity_lag;
    restitutions_ = checkpoint.restitutions;
    overlapping_ = checkpoint.overlapping;
    added_ = checkpoint.added;
    step_count_ = checkpoint.step_count;
    substep_ = checkpoint.substep;
    substeps_since_base_ = checkpoint.substeps_since_base;
    time_base_ = checkpoint.time_base;
    set_schedule(checkpoint.state->ball_count());
    backend_->restore(*checkpoint.state, schedule_);
}

double Simulation::time() const {
    return time_base_ + static_cast<double>(substeps_since_base_) * substep_dt(settings_);
}

void Simulation::rebase_clock() {
    time_base_ = time();
    substeps_since_base_ = 0;
}

void Simulation::change(const Settings& wanted) {
    if (wanted == settings_) {
        return;
    }
    const bool other_count = wanted.balls != settings_.balls;
    const bool other_program = wanted_features(wanted) != schedule_.features;
    const bool other_damping = ball_restitutions(scene_, wanted, settings_.balls) != restitutions_;
    if (other_count || other_program || other_damping) {
        World world;
        if (other_count) {
            // Fewer balls than there are need nothing new; those that were thrown in are none of the scene's.
            const std::uint32_t own = settings_.balls - added_;
            const bool fewer = wanted.balls < settings_.balls;
            world = make_world(scene_, fewer ? std::min(wanted.balls, own) : wanted.balls, seed_);  // may throw
            world.balls.positions.resize(wanted.balls);
            world.balls.velocities.resize(wanted.balls);
        }
        BallState state = synchronised_state();
        rebase_clock();
        if (other_count) {
            const std::size_t kept = std::min<std::size_t>(state.count(), wanted.balls);
            std::copy_n(state.positions.begin(), kept, world.balls.positions.begin());
            std::copy_n(state.velocities.begin(), kept, world.balls.velocities.begin());
            state = std::move(world.balls);
            scene_box_ = united(scene_box_, world.box);  // walls never close in on balls
            overlapping_ = world.overlapping;
            added_ -= std::min(added_, settings_.balls - std::min(settings_.balls, wanted.balls));
        }
        settings_ = wanted;
        load_state(state);
        return;
    }
    rebase_clock();
    const bool other_schedule = wanted.sort != settings_.sort || wanted.cell_factor != settings_.cell_factor ||
                                wanted.walls_low != settings_.walls_low || wanted.walls_high != settings_.walls_high;
    settings_ = wanted;
    if (other_schedule) {
        set_schedule(schedule_.ball_count);
        backend_->reschedule(schedule_);
    }
}

void Simulation::add(const AddBalls& added) {
    const std::size_t count = std::size_t{settings_.balls} + added.balls.size();
    if (count > maximum_balls) {
        throw InputError("no more balls can be added: there would be " + std::to_string(count) + ", at most " +
                         std::to_string(maximum_balls) + " are possible");
    }
    if (added.balls.empty()) {
        return;
    }
    BallState state = synchronised_state();
    for (const BallSpec& spec : added.balls) {
        add_ball(state, spec);
    }
    rebase_clock();
    settings_.balls = static_cast<std::uint32_t>(count);
    added_ += static_cast<std::uint32_t>(added.balls.size());
    load_state(state);
}

void Simulation::apply(const Change& change) {
    if (const auto* settings = std::get_if<Settings>(&change)) {
        this->change(*settings);
    } else {
        add(std::get<AddBalls>(change));
    }
}

void Simulation::use(std::unique_ptr<Backend> backend) {
    load_backend(*backend, raw_state());
    backend_ = std::move(backend);
}

BallState Simulation::raw_state() {
    return {read_slot<vec4>(*backend_, Slot::positions), read_slot<vec4>(*backend_, Slot::velocities), restitutions_,
            velocity_lag_};
}

BallState Simulation::synchronised_state() {
    BallState state = raw_state();
    if (velocity_lag_ == 0.0 || schedule_.dispatches.empty()) {
        return state;
    }
    const auto params =
        make_substep_params(settings_, walls(settings_), schedule_.grid,
                            synchronising_motion(drag(settings_), velocity_lag_), schedule_.ball_count, variety_);
    const auto before = schedule_.in_place ? backend_->save() : nullptr;
    const Bytes status = backend_->read(Slot::status);
    backend_->run(schedule_, params, 0, schedule_.dispatches.size());  // a kick without a drift: not a substep
    state.velocities = read_slot<vec4>(*backend_, schedule_.in_place ? Slot::velocities : Slot::next_velocities);
    state.velocity_lag = 0.0;
    if (before != nullptr) {
        backend_->restore(*before, schedule_);
    } else {
        backend_->write(Slot::status, status);  // what the kick counted does not count
    }
    return state;
}

}  // namespace ballpit
