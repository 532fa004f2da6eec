#include "core/stepper.h"

#include <algorithm>
#include <cstring>
#include <exception>

namespace ballpit {

namespace {

// Steps that are run again for what the last substep leaves: as many as lie between two checkpoints, where there is
// room for any.
constexpr std::uint64_t furthest_made_up = 64;

// Steps fit below, the epoch above.
constexpr std::uint64_t step_bits = 40;

std::uint64_t tag_of(std::uint64_t epoch, std::uint64_t step) { return epoch << step_bits | step; }

// Of a checkpoint, nearly: what grows with the balls.
std::size_t saved_bytes(const Schedule& schedule) {
    const bool compensated = schedule.features.has(Feature::compensated);
    const std::size_t vectors = schedule.keeps_places ? 3 : 2;
    return schedule.ball_count * (vectors * sizeof(vec4) + (compensated ? sizeof(Compensation) : 0));
}

std::optional<std::uint32_t> first_difference(const BallState& a, const BallState& b) {
    const std::uint32_t common = std::min(a.count(), b.count());
    for (std::uint32_t i = 0; i < common; ++i) {
        const bool kept = i < std::min(a.compensations.size(), b.compensations.size());
        if (std::memcmp(&a.positions[i], &b.positions[i], sizeof(vec4)) != 0 ||
            std::memcmp(&a.velocities[i], &b.velocities[i], sizeof(vec4)) != 0 ||
            (kept && std::memcmp(&a.compensations[i], &b.compensations[i], sizeof(Compensation)) != 0)) {
            return i;
        }
    }
    return a.count() == b.count() ? std::nullopt : std::optional(common);
}

}  // namespace

Stepper::Stepper(Simulation& simulation, std::size_t checkpoint_budget)
    : simulation_(simulation), timeline_(checkpoint_budget) {
    reset();
}

void Stepper::reset() {
    timeline_.clear();
    dispatch_ = 0;
    behind_kept_order_ = false;
    divergence_.reset();
    ++epoch_;
    timeline_.add(moment(), simulation_.checkpoint());
    simulation_.backend().request_hash(tag_of(epoch_, moment().step));
}

void Stepper::change(const Change& change) {
    const auto* settings = std::get_if<Settings>(&change);
    if (settings != nullptr && *settings == simulation_.settings()) {
        return;
    }
    go_to({moment(), 0});
    simulation_.apply(change);  // may throw: then nothing is remembered
    ++epoch_;
    timeline_.change(moment(), change);
    timeline_.add(moment(), simulation_.checkpoint());
}

const Schedule& Stepper::schedule_of(bool builds_grid) {
    if (!schedule_ || schedule_change_ != simulation_.schedule_changes()) {
        const Schedule& running = simulation_.schedule();
        schedule_change_ = simulation_.schedule_changes();
        const SortMethod sort = running.counts_cells ? SortMethod::counting : SortMethod::bitonic;  // pass by pass
        schedule_ =
            make_schedule(running.ball_count, running.grid, running.features, sort, simulation_.settings().grid_reuse);
        reused_schedule_ = with_grid_reused(*schedule_);
    }
    return builds_grid ? *schedule_ : reused_schedule_;
}

void Stepper::run_dispatches(std::uint32_t last) {
    if (dispatch_ == 0) {
        simulation_.begin_substep();
    }
    const bool idle = simulation_.still() && simulation_.schedule().in_place;  // it would overwrite what must stay
    if (runner_ && !idle) {
        runner_(schedule(), simulation_.params(), dispatch_, last);
    } else if (!idle) {
        simulation_.backend().run(schedule(), simulation_.params(), dispatch_, last);
    }
    dispatch_ = last;
    if (dispatch_ == dispatches()) {
        const Moment before = moment();
        behind_built_grid_ = simulation_.builds_grid();
        behind_kept_order_ = false;
        simulation_.end_substep();
        arrive(before.step, before.substep);
    }
}

void Stepper::finish_substep() {
    if (dispatch_ > 0 || (runner_ && dispatches() > 0)) {
        run_dispatches(dispatches());
        return;
    }
    const Moment before = moment();
    behind_built_grid_ = simulation_.builds_grid();
    behind_kept_order_ = !watched_ && simulation_.whole_schedule().keeps_order;
    simulation_.substep(watched_);
    arrive(before.step, before.substep);
}

// A new moment: what took hold here when it was first reached takes hold again.
void Stepper::arrive(std::uint64_t step_before, std::uint32_t substep_before) {
    dispatch_ = 0;
    const Moment now = moment();
    if (now.step != step_before) {
        timeline_.record_substeps(step_before, substep_before + 1);
        simulation_.backend().request_hash(tag_of(epoch_, now.step));
    }
    for (const Change& change : timeline_.changes_at(now)) {
        simulation_.apply(change);
    }
    if (now.substep == 0) {
        remember();
    }
}

// Keeps a checkpoint a step, or fewer where a state is so large that the budget would hold only a few.
void Stepper::remember() {
    constexpr std::size_t wanted_checkpoints = 16;
    const Moment now = moment();
    if (timeline_.budget() == 0 || timeline_.has(now)) {
        return;
    }
    const std::size_t bytes = saved_bytes(simulation_.schedule());
    const std::size_t interval = bytes * wanted_checkpoints / timeline_.budget() + 1;
    if (now.step % interval != 0) {
        return;
    }
    try {
        timeline_.add(now, simulation_.checkpoint());
    } catch (const std::exception&) {
        timeline_.set_budget(0);  // the device has no room to remember: what runs goes on, older checkpoints go
    }
}

void Stepper::restore(const Moment& moment) {
    behind_kept_order_ = false;
    simulation_.restore(timeline_.at_or_before(moment).second);
    dispatch_ = 0;
}

void Stepper::run_to(const Moment& target) {
    while (moment() < target) {
        finish_substep();
    }
}

void Stepper::go_to(const Position& target) {
    if (target < position()) {
        // From one substep earlier, so that keys and cells, too, are what the substep before left behind.
        restore(previous_moment(target.moment).value_or(target.moment));
    }
    run_to(target.moment);
    const std::uint32_t wanted = std::min(target.dispatch, dispatches());
    if (wanted > dispatch_) {
        run_dispatches(wanted);
    }
}

void Stepper::set_watched(bool watched) {
    watched_ = watched;
    if (!watched || !behind_kept_order_ || dispatch_ > 0) {
        return;
    }
    const Moment now = moment();
    const std::optional<Moment> before = previous_moment(now);
    if (before && timeline_.at_or_before(*before).first.step + furthest_made_up >= now.step) {
        go_to({*before, 0});
        run_to(now);
    }
}

std::uint32_t Stepper::stage_end(std::uint32_t dispatch) {
    const auto& list = schedule().dispatches;
    std::uint32_t end = dispatch + 1;
    while (end < list.size() && list[end].stage == list[dispatch].stage) {
        ++end;
    }
    return end;
}

std::uint32_t Stepper::stage_start(std::uint32_t dispatch) {
    const auto& list = schedule().dispatches;
    while (dispatch > 0 && list[dispatch - 1].stage == list[dispatch].stage) {
        --dispatch;
    }
    return dispatch;
}

void Stepper::forward(StepUnit unit) {
    const bool empty = dispatches() == 0;  // no balls: a substep has no parts
    switch (unit) {
        case StepUnit::pass:
            return empty ? finish_substep() : run_dispatches(dispatch_ + 1);
        case StepUnit::stage:
            return empty ? finish_substep() : run_dispatches(stage_end(dispatch_));
        case StepUnit::substep:
            return finish_substep();
        case StepUnit::step:
            return to_step_end();
    }
}

std::optional<Moment> Stepper::previous_moment(const Moment& now) const {
    if (now <= timeline_.start()) {
        return std::nullopt;
    }
    return now.substep > 0 ? Moment{now.step, now.substep - 1}
                           : Moment{now.step - 1, timeline_.substeps_of(now.step - 1) - 1};
}

void Stepper::back(StepUnit unit) {
    const Position now = position();
    if (unit == StepUnit::step && (now.moment.substep > 0 || now.dispatch > 0)) {
        return to_step_start();
    }
    if (now.dispatch > 0) {
        switch (unit) {
            case StepUnit::pass:
                return go_to({now.moment, now.dispatch - 1});
            case StepUnit::stage:
                return go_to({now.moment, stage_start(now.dispatch - 1)});
            case StepUnit::substep:
            case StepUnit::step:
                return go_to({now.moment, 0});
        }
    }
    const std::optional<Moment> before = previous_moment(now.moment);
    if (!before) {
        return;
    }
    go_to({unit == StepUnit::step ? std::max(Moment{before->step, 0}, timeline_.start()) : *before, 0});
    if (dispatches() == 0) {
        return;
    }
    const std::uint32_t last = dispatches() - 1;
    if (unit == StepUnit::pass && last > 0) {
        run_dispatches(last);
    } else if (unit == StepUnit::stage && stage_start(last) > 0) {
        run_dispatches(stage_start(last));
    }
}

void Stepper::to_step_start() { go_to({std::max(Moment{moment().step, 0}, timeline_.start()), 0}); }

void Stepper::to_step_end() { run_to({moment().step + 1, 0}); }

void Stepper::update() {
    for (const TaggedHash& arrived : simulation_.backend().take_hashes()) {
        const std::uint64_t step = arrived.tag & ((1ull << step_bits) - 1);
        if (arrived.tag >> step_bits == epoch_ && !timeline_.record_hash(step, arrived.hash) && !divergence_) {
            locate_divergence(step);
        }
    }
}

// Compares the bytes of the first run, where a checkpoint has them, with those of another replay.
void Stepper::locate_divergence(std::uint64_t step) {
    divergence_ = Divergence{step, std::nullopt};
    const Moment at{step, 0};
    if (!timeline_.has(at) || at == timeline_.start()) {
        return;
    }
    const Position now = position();
    restore(at);
    const BallState first = simulation_.raw_state();
    restore(*previous_moment(at));
    run_to(at);
    divergence_->ball = first_difference(first, simulation_.raw_state());
    go_to(now);
}

}  // namespace ballpit
