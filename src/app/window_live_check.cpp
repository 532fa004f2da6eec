#include "app/window_live_check.h"

#include <chrono>
#include <string>
#include <utility>

#include "core/stopwatch.h"

namespace ballpit::app {

namespace {

// "substep 0, collide, ball 3: …" without the number of the substep: a check begins anew in each.
std::string without_substep(const std::string& first) {
    const std::size_t comma = first.find(", ");
    return comma == std::string::npos ? first : first.substr(comma + 2);
}

bool worse(const measure::CheckRow& a, const measure::CheckRow& b) {
    return std::pair(a.beyond_bound, a.differing) > std::pair(b.beyond_bound, b.differing);
}

}  // namespace

void LiveCheck::set_mode(ui::LiveCheckMode mode) {
    mode_ = mode;
    checker_.reset();
    if (mode == ui::LiveCheckMode::off) {
        shown_.reset();
        session_.stepper().set_runner({});
        return;
    }
    session_.run_again([this] {
        session_.stepper().set_runner([this](const Schedule& schedule, const SubstepParams<double>& params,
                                             std::size_t first,
                                             std::size_t last) { run(schedule, params, first, last); });
    });
}

bool LiveCheck::compares() const {
    return mode_ == ui::LiveCheckMode::mirror && session_.simulation().backend().name() == "gpu";
}

void LiveCheck::begin_substep() {
    Simulation& simulation = session_.simulation();
    moment_ = {simulation.step_count(), simulation.substep_in_step()};
    layout_ = session_.layout_changes();
    writes_ = {};
    ended_ = {};
    last_ms_ = std::exchange(ms_, 0.0);
    if (compares()) {
        checker_.emplace(simulation.backend(), mirror_);
    } else {
        checker_.emplace(simulation.backend());
    }
    checker_->load(simulation.raw_state(), simulation.schedule(), simulation.settings().limit_force);
}

// A whole substep runs with the sort that is chosen, in parts it is stepped pass by pass.
void LiveCheck::run(const Schedule& schedule, const SubstepParams<double>& params, std::size_t first,
                    std::size_t last) {
    const auto start = std::chrono::steady_clock::now();
    const bool whole = first == 0 && last == schedule.dispatches.size();
    const Schedule& what = whole ? session_.simulation().schedule() : schedule;
    const std::size_t end = whole ? what.dispatches.size() : last;
    if (first == 0) {
        begin_substep();
    }
    checker_->run(what, params, first, end);
    ran_ = static_cast<std::uint32_t>(last);
    for (std::size_t i = first; i < end; ++i) {
        const Dispatch& dispatch = what.dispatches[i];
        const auto stage = static_cast<std::size_t>(dispatch.stage);
        for (const Slot slot : dispatch.writes) {
            ++writes_[stage][static_cast<std::size_t>(slot)];
        }
        ended_[stage] = i + 1 == what.dispatches.size() || what.dispatches[i + 1].stage != dispatch.stage;
    }
    ms_ += milliseconds_since(start);
}

bool LiveCheck::holds_for_place() const {
    const ui::Place place = session_.place();
    return checker_ && layout_ == session_.layout_changes() && place.substep == moment_ && place.ran == ran_;
}

ui::StageCheck LiveCheck::stage_check(Stage stage) const {
    ui::StageCheck check;
    const auto& writes = writes_[static_cast<std::size_t>(stage)];
    const auto written = [&](Slot slot) { return writes[static_cast<std::size_t>(slot)]; };
    check.compared = compares();
    check.violation = checker_->violation(stage);
    const measure::CheckRow* worst = nullptr;
    for (const measure::CheckRow& row : checker_->rows()) {
        if (row.stage != stage || written(row.slot) == 0) {
            continue;
        }
        worst = worst == nullptr || worse(row, *worst) ? &row : worst;
        if (row.differing > 0 && checker_->bytes(row.slot)) {
            const measure::CheckedBytes& bytes = *checker_->bytes(row.slot);
            check.differences.push_back({row.slot, bytes.dispatch, bytes.gpu, bytes.cpu, bytes.differing});
        }
    }
    check.ran = worst != nullptr || ended_[static_cast<std::size_t>(stage)];
    if (worst != nullptr) {
        check.elements = worst->elements / written(worst->slot);
        check.differing = worst->differing;
        check.beyond_bound = worst->beyond_bound;
        check.max_ulp = worst->max_ulp;
        check.of_bound = worst->of_bound;
        check.first = without_substep(worst->first);
    }
    return check;
}

void LiveCheck::describe(ui::LiveCheckState& state) {
    state = {};
    state.mode = mode_;
    state.shown = shown_;
    state.ms = ms_ > 0.0 && ended_[static_cast<std::size_t>(Stage::collide)] ? ms_ : last_ms_;
    state.mirror_computes = session_.simulation().backend().name() != "gpu";
    if (mode_ != ui::LiveCheckMode::off && holds_for_place()) {
        for (std::size_t i = 0; i < stage_count; ++i) {
            state.stages[i] = stage_check(static_cast<Stage>(i));
        }
    }
}

}  // namespace ballpit::app
