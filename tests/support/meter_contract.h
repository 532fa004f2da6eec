// What the readings of every backend are held to.
#pragma once

#include <functional>
#include <memory>

#include "core/backend.h"

namespace ballpit::test {

using MakeBackend = std::function<std::unique_ptr<Backend>()>;

/// Readings of scenes with every law, with and without a grid, in place, with each integrator, against the mirror's on
/// the same bytes, within what float sums may differ.
void readings_agree_with_the_mirror(const MakeBackend& make);
/// More readings than a device keeps, each once, in order; the same bits in every run.
void readings_arrive_in_order(const MakeBackend& make);
/// A metered run ends on the bytes of one that is not, whether its moments are metered on the way or ahead.
void metering_changes_nothing(const MakeBackend& make);

}  // namespace ballpit::test
