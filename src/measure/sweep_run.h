// A run of a scene in slices of wall time, step by step timed.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/simulation.h"

namespace ballpit::measure {

class SweepRun {
public:
    /// Throws what Simulation does.
    SweepRun(const Scene& scene, const Settings& settings, std::uint64_t seed, std::unique_ptr<Backend> backend)
        : simulation_(scene, settings, seed, std::move(backend)) {}

    /// Runs to the end of a step, or for about so long (ms); waits for the device. True where a step has ended.
    bool advance(double budget_ms);

    Simulation& simulation() { return simulation_; }
    const std::vector<double>& step_ms() const { return step_ms_; }  // of whole steps
    /// Whole steps of this run, wherever the scene's own clock began.
    std::uint64_t steps() const { return step_ms_.size(); }
    std::uint64_t substeps() const { return substeps_; }
    double spent_ms() const { return spent_ms_; }
    /// s of the wall clock that so many steps will take; nothing until it can be told.
    std::optional<double> seconds_for(std::uint64_t steps) const;
    /// Mean; 0 before the first.
    double substep_ms() const { return substeps_ == 0 ? 0.0 : spent_ms_ / static_cast<double>(substeps_); }

private:
    Simulation simulation_;
    std::vector<double> step_ms_;
    double this_step_ms_ = 0.0;
    double spent_ms_ = 0.0;
    std::uint64_t substeps_ = 0;
};

/// "12 s", rounded up.
std::string seconds_text(double seconds);

}  // namespace ballpit::measure
