#include "app/law_meter.h"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <utility>

#include "core/stopwatch.h"
#include "measure/statistics.h"

namespace ballpit::app {

namespace {

constexpr std::size_t pairs = 9;
constexpr std::size_t warm_up = 2;       // runs: programs are finished and caches filled by the first of each
constexpr std::size_t most_waiting = 4;  // runs whose times have not arrived

bool same_programs(const Schedule& a, const Schedule& b) {
    return std::ranges::equal(a.dispatches, b.dispatches, {}, &Dispatch::program, &Dispatch::program);
}

// First one, then the other, then the other first: what drifts is shared fairly.
bool turned_first(std::size_t run) { return run / 2 % 2 == 1; }

}  // namespace

void LawMeter::start(Simulation& simulation, std::unique_ptr<Backend> twin) {
    stop();
    settings_ = simulation.settings();
    settings_.pull.reset();
    if (settings_.balls == 0) {
        return;
    }
    state_ = simulation.raw_state();
    as_it_is_.plan = simulation.plan(settings_);
    for (std::size_t i = 0; i < law_count; ++i) {
        Settings turned = settings_;
        bool& law = turned.laws.*law_table()[i].member;
        law = !law;
        Plan plan = simulation.plan(turned);
        if (same_programs(plan.schedule, as_it_is_.plan.schedule)) {
            costs_[i] = ui::LawCost{{}, true};
        } else {
            plans_[i] = std::move(plan);
        }
    }
    twin_ = std::move(twin);
    twin_->set_timing(true);
    load(as_it_is_);
}

void LawMeter::load(Variant& variant) {
    state_.restitutions = variant.plan.restitutions;
    twin_->load(state_, variant.plan.schedule, settings_.limit_force);
    variant.state = twin_->save();
}

// False where all laws are measured.
bool LawMeter::begin_law() {
    while (law_ < law_count && !plans_[law_]) {
        ++law_;
    }
    if (law_ == law_count) {
        return false;
    }
    turned_.plan = *std::exchange(plans_[law_], std::nullopt);
    load(turned_);
    started_ = 0;
    begun_ = true;
    as_it_is_ms_.clear();
    turned_ms_.clear();
    return true;
}

void LawMeter::run_next() {
    const bool second = started_ % 2 == 1;
    const Variant& variant = turned_first(started_) != second ? turned_ : as_it_is_;
    twin_->restore(*variant.state, variant.plan.schedule);
    twin_->run(variant.plan.schedule, variant.plan.params, 0, variant.plan.schedule.dispatches.size());
    ++started_;
    ++runs_;
}

// Times arrive in the order of the runs.
void LawMeter::collect() {
    for (const StageTimes& times : twin_->take_times()) {
        const std::size_t run = as_it_is_ms_.size() + turned_ms_.size();
        const bool second = run % 2 == 1;
        (turned_first(run) != second ? turned_ms_ : as_it_is_ms_)
            .push_back(std::accumulate(times.begin(), times.end(), 0.0));
    }
}

void LawMeter::finish_law() {
    const auto measured = [](const std::vector<double>& ms) { return std::span(ms).subspan(warm_up / 2); };
    const bool holds = settings_.laws.*law_table()[law_].member;
    const auto with = measured(holds ? as_it_is_ms_ : turned_ms_);
    const auto without = measured(holds ? turned_ms_ : as_it_is_ms_);
    costs_[law_] = ui::LawCost{measure::paired_cost(with, without), false};
    const auto now = measured(as_it_is_ms_);
    substep_ms_ = measure::median({now.begin(), now.end()});
    begun_ = false;
    ++law_;
}

void LawMeter::update(double budget_ms) {
    const auto start = std::chrono::steady_clock::now();
    constexpr std::size_t runs_a_law = warm_up + 2 * pairs;
    do {
        if (!busy() || (!begun_ && !begin_law())) {
            twin_.reset();
            state_ = {};
            as_it_is_ = {};
            turned_ = {};
            return;
        }
        collect();
        const std::size_t arrived = as_it_is_ms_.size() + turned_ms_.size();
        if (arrived == runs_a_law) {
            finish_law();
        } else if (started_ < runs_a_law && started_ - arrived < most_waiting) {
            run_next();
        } else {
            return;  // times are still to come
        }
    } while (milliseconds_since(start) < budget_ms);
}

}  // namespace ballpit::app
