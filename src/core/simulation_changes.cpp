// What a user does to a running Simulation: other settings, more balls, another backend.
#include <algorithm>
#include <string>
#include <utility>

#include "core/error.h"
#include "core/scene_schedule.h"
#include "core/simulation.h"

namespace ballpit {

void Simulation::change(const Settings& wanted) {
    if (wanted != run_.settings) {
        all_or_nothing([&] { change_now(wanted); });
    }
}

void Simulation::change_now(const Settings& wanted) {
    interrupt_meters(wanted);
    const bool other_count = wanted.balls != run_.settings.balls;
    // Where collide reads the state from is no other law: the balls stay as they are.
    const auto laws = [](Features features) {
        return features.without(Feature::sorted_copies).without(Feature::kept_order);
    };
    const bool other_program = laws(wanted_features(wanted)) != laws(schedule_.features);
    const bool other_damping = ball_restitutions(scene_, wanted, run_.settings.balls) != run_.restitutions;
    if (other_count || other_program || other_damping) {
        expect_storage(
            scene_schedule(wanted, run_.scene_box, run_.walls, run_.largest_radius, run_.variety, wanted.balls),
            backend_->storage_limits());
        World world;
        if (other_count) {
            // Fewer balls than there are need nothing new; those that were thrown in are none of the scene's.
            const std::uint32_t own = run_.settings.balls - run_.added;
            const bool fewer = wanted.balls < run_.settings.balls;
            world = make_world(scene_, fewer ? std::min(wanted.balls, own) : wanted.balls, seed_);  // may throw
            world.balls.positions.resize(wanted.balls);
            world.balls.velocities.resize(wanted.balls);
            world.balls.compensations.resize(wanted.balls);
        }
        BallState state = synchronised_state();
        rebase_clock();
        if (other_count) {
            const std::size_t kept = std::min<std::size_t>(state.count(), wanted.balls);
            std::copy_n(state.positions.begin(), kept, world.balls.positions.begin());
            std::copy_n(state.velocities.begin(), kept, world.balls.velocities.begin());
            state.compensations.resize(state.count());
            std::copy_n(state.compensations.begin(), kept, world.balls.compensations.begin());
            state = std::move(world.balls);
            run_.scene_box = united(run_.scene_box, world.box);  // walls never close in on balls
            run_.overlapping = world.overlapping;
            run_.added -= std::min(run_.added, run_.settings.balls - std::min(run_.settings.balls, wanted.balls));
        }
        run_.settings = wanted;
        const Status counted = read_slot<Status>(*backend_, Slot::status).front();
        load_state(std::move(state));
        add_to_status(counted);
        return;
    }
    rebase_clock();
    const bool other_schedule =
        wanted.sort != run_.settings.sort || wanted.cell_factor != run_.settings.cell_factor ||
        wanted.grid_reuse != run_.settings.grid_reuse || wanted.sorted_copies != run_.settings.sorted_copies ||
        wanted.keep_order != run_.settings.keep_order || wanted.walls_low != run_.settings.walls_low ||
        wanted.walls_high != run_.settings.walls_high;
    run_.settings = wanted;
    if (other_schedule) {
        set_schedule(schedule_.ball_count);
        backend_->reschedule(schedule_);
        choose_sort();
    }
}

void Simulation::add(const AddBalls& added) {
    const std::size_t count = std::size_t{run_.settings.balls} + added.balls.size();
    if (count > maximum_balls) {
        throw InputError("no more balls can be added: there would be " + std::to_string(count) + ", at most " +
                         std::to_string(maximum_balls) + " are possible");
    }
    if (!added.balls.empty()) {
        all_or_nothing([&] { add_now(added); });
    }
}

void Simulation::add_now(const AddBalls& added) {
    BallState state = synchronised_state();
    state.compensations.resize(state.count());
    for (const BallSpec& spec : added.balls) {
        add_ball(state, spec);
    }
    rebase_clock();
    interrupt_meters();
    run_.settings.balls += static_cast<std::uint32_t>(added.balls.size());
    run_.added += static_cast<std::uint32_t>(added.balls.size());
    const Status counted = read_slot<Status>(*backend_, Slot::status).front();
    load_state(std::move(state));
    add_to_status(counted);
}

void Simulation::apply(const Change& change) {
    if (const auto* settings = std::get_if<Settings>(&change)) {
        this->change(*settings);
    } else if (const auto* balls = std::get_if<AddBalls>(&change)) {
        add(*balls);
    } else {
        relax();
    }
    run_.grid_age = 0;  // also where a slider came back to where it was: a replay does not know that it had moved
}

void Simulation::use(std::unique_ptr<Backend> backend) {
    const Status counted = read_slot<Status>(*backend_, Slot::status).front();
    load_backend(*backend, raw_state());
    backend_ = std::move(backend);
    run_.grid_age = 0;
    sort_chosen_for_ = 0;  // what was quickest there need not be quickest here
    choose_sort();
    add_to_status(counted);
    interrupt_meters();
}

}  // namespace ballpit
