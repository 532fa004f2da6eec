// The error budget in the window: what is allowed, what the probe measured of the settings that run, and the count that
// would do.
#pragma once

#include <optional>
#include <string>

#include "core/settings.h"
#include "measure/error_budget.h"

namespace ballpit::ui {

struct BudgetOptions {
    measure::ErrorBudget budget;
    bool historical = false;
    friend bool operator==(const BudgetOptions&, const BudgetOptions&) = default;
};

inline constexpr double least_allowed = 1e-4;
inline constexpr double most_allowed = 1.0;

struct BudgetState {
    BudgetOptions options;
    bool measuring = false;
    std::optional<measure::ProbeResult> probe;  // of the settings that run
    double drift = 0.0;                         // 1/s, of these
    std::optional<measure::BudgetChoice> choice;
    std::string sentence;         // what was chosen and why
    bool applied = false;         // it runs already
    double firm_stiffness = 0.0;  // N/m, for overlaps of a twentieth of a diameter
    double typical_speed = 0.0;   // m/s, of the balls when they were looked at
    double largest_speed = 0.0;
    bool speed_is_assumed = false;
    std::optional<double> substep_ms;  // of the scene that runs
    double probe_ms = 0.0;             // work of this program for the last probe and choice together
    std::uint32_t probe_substeps = 0;  // that they ran
};

}  // namespace ballpit::ui
