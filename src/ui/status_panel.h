// What has gone wrong at the extremes, and what may, in words (core/extremes.h).
#pragma once

#include <string>
#include <vector>

#include "core/extremes.h"

namespace ballpit::ui {

/// One sentence for each that is not 0: what happened, how often, what helps. `alarms`: what a stage has counted; else
/// what is only to be warned of.
std::vector<std::string> extreme_sentences(const ExtremeNumbers& numbers, bool alarms);

}  // namespace ballpit::ui
