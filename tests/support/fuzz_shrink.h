// Makes a failing case smaller: fewer balls, laws, steps and changes, rounder numbers, as long as it still fails.
#pragma once

#include <functional>

#include "support/fuzz_case.h"

namespace ballpit::test {

/// `fails`: whether a case shows the same failure. The case given does. Tries at most `tries` others.
FuzzCase shrunk(FuzzCase fuzz_case, const std::function<bool(const FuzzCase&)>& fails, int tries = 3000);

}  // namespace ballpit::test
