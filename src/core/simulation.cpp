#include "core/simulation.h"

#include <algorithm>

namespace ballpit {

namespace {

double largest_radius(const std::vector<vec4>& positions) {
    float largest = 0.0f;
    for (const vec4& p : positions) {
        largest = std::max(largest, p.w);
    }
    return static_cast<double>(largest);
}

}  // namespace

Simulation::Simulation(Scene scene, const Settings& settings, std::uint64_t seed, std::unique_ptr<Backend> backend)
    : backend_(std::move(backend)) {
    load(std::move(scene), settings, seed);
}

void Simulation::load(Scene scene, const Settings& settings, std::uint64_t seed) {
    World world = make_world(scene, settings.balls, seed);
    scene_ = std::move(scene);
    settings_ = settings;
    seed_ = seed;
    load_world(world);
}

void Simulation::restart(std::uint64_t seed) {
    seed_ = seed;
    load_world(make_world(scene_, settings_.balls, seed));
}

void Simulation::load_world(const World& world) {
    half_extent_ = world.half_extent;
    overlapping_ = world.overlapping;
    step_count_ = 0;
    substep_ = 0;
    substeps_since_base_ = 0;
    time_base_ = 0.0;
    load_state(world.balls);
}

void Simulation::load_state(const BallState& state) {
    restitutions_ = ball_restitutions(scene_, settings_.restitution, state.count());
    velocity_lag_ = state.velocity_lag;
    largest_radius_ = largest_radius(state.positions);
    schedule_ = wanted_schedule(state.count());
    backend_->load({state.positions, state.velocities, restitutions_, velocity_lag_}, schedule_, settings_.limit_force);
}

Schedule Simulation::wanted_schedule(std::uint32_t ball_count) const {
    const Grid grid = make_grid(half_extent_, largest_radius_, settings_.cell_factor, ball_count);
    return make_schedule(ball_count, grid, scene_features(scene_, settings_), settings_.sort);
}

SubstepParams<double> Simulation::params() const {
    const SubstepMotion motion = substep_motion(settings_.integrator, drag(), substep_dt(), velocity_lag_);
    return make_substep_params(settings_, half_extent_, schedule_.grid, motion, schedule_.ball_count);
}

void Simulation::end_substep() {
    backend_->swap_states();
    velocity_lag_ = substep_motion(settings_.integrator, drag(), substep_dt(), velocity_lag_).lag_after;
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
    return {backend_->save(), settings_,   half_extent_, largest_radius_,      velocity_lag_, restitutions_,
            overlapping_,     step_count_, substep_,     substeps_since_base_, time_base_};
}

void Simulation::restore(const Checkpoint& checkpoint) {
    settings_ = checkpoint.settings;
    half_extent_ = checkpoint.half_extent;
    largest_radius_ = checkpoint.largest_radius;
    velocity_lag_ = checkpoint.velocity_lag;
    restitutions_ = checkpoint.restitutions;
    overlapping_ = checkpoint.overlapping;
    step_count_ = checkpoint.step_count;
    substep_ = checkpoint.substep;
    substeps_since_base_ = checkpoint.substeps_since_base;
    time_base_ = checkpoint.time_base;
    schedule_ = wanted_schedule(checkpoint.state->ball_count());
    backend_->restore(*checkpoint.state, schedule_);
}

double Simulation::time() const { return time_base_ + static_cast<double>(substeps_since_base_) * substep_dt(); }

void Simulation::rebase_clock() {
    time_base_ = time();
    substeps_since_base_ = 0;
}

void Simulation::change(const Settings& wanted) {
    if (wanted == settings_) {
        return;
    }
    rebase_clock();
    const bool other_count = wanted.balls != settings_.balls;
    const bool other_program = scene_features(scene_, wanted) != schedule_.features;
    const bool other_damping = wanted.restitution != settings_.restitution && !restitutions_.empty();
    if (other_count || other_program || other_damping) {
        World world;
        if (other_count) {
            world = make_world(scene_, wanted.balls, seed_);  // may throw: nothing has changed yet
        }
        BallState state = synchronised_state();
        if (other_count) {
            const std::size_t kept = std::min<std::size_t>(state.count(), wanted.balls);
            std::copy_n(state.positions.begin(), kept, world.balls.positions.begin());
            std::copy_n(state.velocities.begin(), kept, world.balls.velocities.begin());
            state = std::move(world.balls);
            half_extent_ = glm::max(half_extent_, world.half_extent);  // walls never close in on balls
            overlapping_ = world.overlapping;
        }
        settings_ = wanted;
        load_state(state);
        return;
    }
    const bool other_schedule = wanted.sort != settings_.sort || wanted.cell_factor != settings_.cell_factor;
    settings_ = wanted;
    if (other_schedule) {
        schedule_ = wanted_schedule(schedule_.ball_count);
        backend_->reschedule(schedule_);
    }
}

void Simulation::use(std::unique_ptr<Backend> backend) {
    const BallState state = raw_state();
    backend->load(state, schedule_, settings_.limit_force);
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
    const auto kick = make_substep_params(settings_, half_extent_, schedule_.grid,
                                          synchronising_motion(drag(), velocity_lag_), schedule_.ball_count);
    const Bytes status = backend_->read(Slot::status);
    backend_->run(schedule_, kick, 0, schedule_.dispatches.size());  // lands in the next_ slots: not a substep
    backend_->write(Slot::status, status);                           // so its counts do not count
    state.velocities = read_slot<vec4>(*backend_, Slot::next_velocities);
    state.velocity_lag = 0.0;
    return state;
}

}  // namespace ballpit
