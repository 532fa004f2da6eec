// What a grid that several substeps use is held to on every backend.
#pragma once

#include <functional>
#include <memory>

#include "core/backend.h"

namespace ballpit::test {

using MakeBackend = std::function<std::unique_ptr<Backend>()>;

/// Wide enough cells: nothing is missed, and but for the order of sums the run is the one with a grid a substep.
void wide_cells_miss_nothing(const MakeBackend& make);
/// Too narrow ones: as many contacts are told to be missed, and as long a way, as counting every pair in double gives.
void missed_contacts_are_counted(const MakeBackend& make);
/// From each dispatch back and forth, the bytes of every slot, what was counted included.
void steps_back_and_forth(const MakeBackend& make);
/// Looking at the present moment leaves no trace in what comes.
void looking_changes_nothing(const MakeBackend& make);

}  // namespace ballpit::test
