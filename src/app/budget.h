// --budget: the substeps that a preset of the error budget asks for, chosen before the run begins.
#pragma once

#include <optional>
#include <string>

#include "app/options.h"
#include "app/report.h"
#include "core/backend.h"
#include "core/simulation.h"
#include "measure/error_budget.h"

namespace ballpit::app {

/// The preset of that name; nothing for an empty one. Throws InputError.
std::optional<measure::BudgetPreset> parse_budget(const std::string& name);

/// Throws InputError where the command line gives a count of substeps beside --budget.
void check_budget(const Options& options);

/// Chooses for the simulation, which is at its start, and puts substeps and integrator into `settings`. Meters the
/// balls once; single collisions run on `probes`, which must be loaded anew afterwards if it is the simulation's own.
/// Throws what Backend::load and make_world throw.
measure::BudgetChoice apply_budget(measure::BudgetPreset preset, Simulation& simulation, Backend& probes,
                                   Settings& settings);

/// The chosen settings, in place of those that run.
Settings with_choice(Settings settings, const measure::BudgetChoice& choice);

/// "ballpit: budget balanced: 48 substeps ..." to stderr.
void tell(measure::BudgetPreset preset, const measure::BudgetChoice& choice);

Json budget_json(measure::BudgetPreset preset, const measure::BudgetChoice& choice);

}  // namespace ballpit::app
