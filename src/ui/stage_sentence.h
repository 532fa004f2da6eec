// One sentence about the dispatch that ran last, with this frame's numbers.
#pragma once

#include <string>

#include "measure/stage_numbers.h"
#include "ui/stepping.h"

namespace ballpit::ui {

/// Empty for no numbers.
std::string stage_sentence(const measure::StageNumbers& numbers);

/// "Step 413, substep 4 of 8, dispatch 17 of 95". Steps count from 1: step 1 leads from t = 0 to dt.
std::string place_text(const SteppingState& stepping);

/// 0.0032 m as "3.2 mm".
std::string length_text(double metres);

}  // namespace ballpit::ui
