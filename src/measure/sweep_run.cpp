#include "measure/sweep_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/stopwatch.h"

namespace ballpit::measure {

namespace {

constexpr std::uint64_t judged_after = 64;  // substeps
constexpr double ms_a_s = 1000.0;

// Substeps that fit into what is left of the budget; nobody knows how long the first one takes.
std::uint32_t that_fit(double budget_ms, double substep_ms, std::uint32_t left) {
    if (std::isinf(budget_ms)) {
        return left;
    }
    const double fit = substep_ms > 0.0 ? budget_ms / substep_ms : 1.0;
    return static_cast<std::uint32_t>(std::clamp(fit, 1.0, static_cast<double>(left)));
}

}  // namespace

bool SweepRun::advance(double budget_ms) {
    const std::uint32_t left = simulation_.settings().substeps - simulation_.substep_in_step();
    const std::uint32_t wanted = that_fit(budget_ms, substep_ms(), left);
    const auto start = std::chrono::steady_clock::now();
    for (std::uint32_t i = 0; i < wanted; ++i) {
        simulation_.substep();
    }
    simulation_.backend().finish();
    const double ms = milliseconds_since(start);
    this_step_ms_ += ms;
    spent_ms_ += ms;
    substeps_ += wanted;
    if (wanted < left) {
        return false;
    }
    step_ms_.push_back(this_step_ms_);
    this_step_ms_ = 0.0;
    return true;
}

std::optional<double> SweepRun::seconds_for(std::uint64_t steps) const {
    if (substeps_ < judged_after) {
        return std::nullopt;
    }
    return substep_ms() / ms_a_s * simulation_.settings().substeps * static_cast<double>(steps);
}

std::string seconds_text(double seconds) { return std::to_string(static_cast<long long>(std::ceil(seconds))) + " s"; }

}  // namespace ballpit::measure
