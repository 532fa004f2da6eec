// What each law costs in a substep: on a backend of its own, substeps of a copy of one state run in turn with a law and
// without it, everything else equal. One substep or a few a frame, so that the window stays quick; times are taken when
// they are there.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/laws.h"
#include "core/simulation.h"
#include "ui/laws.h"

namespace ballpit::app {

class LawMeter {
public:
    /// Copies the present state, which may wait for the device, and forgets what was measured. `twin`: a backend of
    /// its own.
    void start(Simulation& simulation, std::unique_ptr<Backend> twin);
    /// Gives the twin back and forgets everything.
    void stop() { *this = LawMeter(); }

    /// Runs substeps for about so long, at least one while there is something to measure. Throws what
    /// Backend::load throws.
    void update(double budget_ms);
    bool busy() const { return twin_ != nullptr; }

    const std::array<std::optional<ui::LawCost>, law_count>& costs() const { return costs_; }
    /// A substep as it is; nothing until a law was measured.
    std::optional<double> substep_ms() const { return substep_ms_; }
    /// Substeps run so far.
    std::uint64_t runs() const { return runs_; }

private:
    // The substep as it is, or with one law turned over.
    struct Variant {
        Plan plan;
        std::unique_ptr<SavedState> state;
    };
    enum class Which : std::uint8_t { as_it_is, turned };

    void load(Variant& variant);
    bool begin_law();
    void run_next();
    void collect();
    void finish_law();

    std::unique_ptr<Backend> twin_;
    BallState state_;
    Settings settings_;
    Variant as_it_is_;
    Variant turned_;
    std::array<std::optional<Plan>, law_count> plans_;  // with the law turned over; none where nothing changes
    std::size_t law_ = 0;
    bool begun_ = false;
    std::size_t started_ = 0;  // runs of this law
    std::vector<double> as_it_is_ms_;
    std::vector<double> turned_ms_;
    std::array<std::optional<ui::LawCost>, law_count> costs_;
    std::optional<double> substep_ms_;
    std::uint64_t runs_ = 0;
};

}  // namespace ballpit::app
