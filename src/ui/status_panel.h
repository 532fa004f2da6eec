// What the GPU's status word says, in words.
#pragma once

#include <string>
#include <vector>

#include "core/layout.h"

namespace ballpit::ui {

/// One sentence for each bit that is set: stage, count, what helps.
std::vector<std::string> failure_sentences(const Status& status);

}  // namespace ballpit::ui
