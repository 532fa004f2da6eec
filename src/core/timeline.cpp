#include "core/timeline.h"

#include <cassert>
#include <iterator>
#include <utility>

namespace ballpit {

namespace {

// The newest ones stay, so that a single dispatch back never means a long replay.
constexpr std::ptrdiff_t newest_kept = 3;

std::size_t cost(const Checkpoint& checkpoint) { return checkpoint.state->bytes() + checkpoint_overhead; }

bool same_ball_pulled(const Settings& a, const Settings& b) {
    return a.pull && b.pull ? a.pull->ball == b.pull->ball : !a.pull && !b.pull;
}

// Whether a change to `b` at the moment of a change to `a` leaves nothing of `a`: no balls came or went, and the state
// was not touched.
bool replaces(const Change& before, const Change& after) {
    const auto* a = std::get_if<Settings>(&before);
    const auto* b = std::get_if<Settings>(&after);
    return a != nullptr && b != nullptr && a->balls == b->balls && a->laws == b->laws &&
           a->integrator == b->integrator && a->neighbours == b->neighbours && a->limit_force == b->limit_force &&
           a->dashpot == b->dashpot && a->restitution == b->restitution && same_ball_pulled(*a, *b) &&
           a->shake_amplitude == b->shake_amplitude && a->walls_low == b->walls_low && a->walls_high == b->walls_high;
}

}  // namespace

void Timeline::clear() {
    checkpoints_.clear();
    changes_.clear();
    first_step_.reset();
    steps_.clear();
    used_ = 0;
}

void Timeline::set_budget(std::size_t bytes) {
    budget_ = bytes;
    shrink();
}

void Timeline::add(const Moment& moment, Checkpoint&& checkpoint) {
    const std::size_t bytes = cost(checkpoint);
    first_step_ = first_step_.value_or(moment.step);
    const auto [place, added] = checkpoints_.try_emplace(moment, std::move(checkpoint));
    if (added) {
        used_ += bytes;
        shrink();
    }
}

void Timeline::shrink() {
    while (used_ > budget_ && checkpoints_.size() > newest_kept + 1) {
        const double newest = static_cast<double>(checkpoints_.rbegin()->first.step) + 1.0;
        auto victim = checkpoints_.end();
        double smallest = 0.0;
        const auto last = std::prev(checkpoints_.end(), newest_kept);
        for (auto it = std::next(checkpoints_.begin()); it != last; ++it) {
            const double gap = static_cast<double>(std::next(it)->first.step - std::prev(it)->first.step);
            const double age = newest - static_cast<double>(it->first.step);
            if (victim == checkpoints_.end() || gap / age < smallest) {
                victim = it;
                smallest = gap / age;
            }
        }
        used_ -= cost(victim->second);
        checkpoints_.erase(victim);
    }
}

const std::pair<const Moment, Checkpoint>& Timeline::at_or_before(const Moment& moment) const {
    auto after = checkpoints_.upper_bound(moment);
    assert(after != checkpoints_.begin());
    return *std::prev(after);
}

void Timeline::change(const Moment& moment, const Change& change) {
    for (auto it = checkpoints_.lower_bound(moment); it != checkpoints_.end(); it = checkpoints_.erase(it)) {
        used_ -= cost(it->second);
    }
    changes_.erase(changes_.upper_bound(moment), changes_.end());
    std::vector<Change>& here = changes_[moment];
    if (!here.empty() && replaces(here.back(), change)) {
        here.back() = change;  // a slider that is dragged while paused leaves its last value only
    } else {
        here.push_back(change);
    }
    // On arriving at this step the state was what it was; only what comes after it is open again.
    const std::uint64_t kept = moment.step + 1 - *first_step_;
    if (steps_.size() > kept) {
        steps_.resize(kept);
    }
}

std::span<const Change> Timeline::changes_at(const Moment& moment) const {
    const auto found = changes_.find(moment);
    return found == changes_.end() ? std::span<const Change>() : std::span(found->second);
}

Timeline::StepRecord& Timeline::record(std::uint64_t step) {
    assert(first_step_ && step >= *first_step_);
    const std::uint64_t place = step - *first_step_;
    if (steps_.size() <= place) {
        steps_.resize(place + 1);
    }
    return steps_[place];
}

const Timeline::StepRecord* Timeline::find_record(std::uint64_t step) const {
    return first_step_ && step >= *first_step_ && step - *first_step_ < steps_.size() ? &steps_[step - *first_step_]
                                                                                      : nullptr;
}

void Timeline::record_substeps(std::uint64_t step, std::uint32_t substeps) { record(step).substeps = substeps; }

std::uint32_t Timeline::substeps_of(std::uint64_t step) const {
    const StepRecord* found = find_record(step);
    return found == nullptr ? 0 : found->substeps;
}

bool Timeline::record_hash(std::uint64_t step, std::uint64_t hash) {
    StepRecord& remembered = record(step);
    if (remembered.hash && *remembered.hash != hash) {
        return false;
    }
    remembered.hash = hash;
    return true;
}

std::optional<std::uint64_t> Timeline::hash(std::uint64_t step) const {
    const StepRecord* found = find_record(step);
    return found == nullptr ? std::nullopt : found->hash;
}

}  // namespace ballpit
