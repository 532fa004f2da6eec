// What a choice of substeps is told in.
#pragma once

#include <string>

#include "measure/error_budget.h"

namespace ballpit::measure {

/// Nothing touches, or nothing moves.
std::string nothing_sentence(const std::string& why, const BudgetChoice& choice);

/// What was chosen, what decides, whether it fits into the step's time and, where it does not, what would; what floats
/// set an end to.
std::string budget_sentence(const BudgetQuestion& question, const BudgetChoice& choice);

/// N/m: with this stiffness the largest overlap, `softness` diameters now, would be a twentieth of one.
double firm_stiffness(const BudgetQuestion& question, double softness);

}  // namespace ballpit::measure
