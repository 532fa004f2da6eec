// What holds on every backend however a substep is computed: by any sort, from copies or not.
#pragma once

#include <cstdint>

#include "support/grid_reuse_contract.h"

namespace ballpit::test {

/// Every shipped scene, `balls` of each, gives one hash after `steps` steps.
void same_run_however_computed(const MakeBackend& make, std::uint32_t balls, int steps);
void changes_of_computing_change_nothing(const MakeBackend& make);
void automatic_sort_is_one_of_them(const MakeBackend& make);

}  // namespace ballpit::test
