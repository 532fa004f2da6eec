// From the copies of the buffers to one substep that they tell of.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/backend.h"
#include "measure/ball_probe.h"

namespace ballpit::app {

/// Copies of one moment; null where there is none.
struct SlotBytes {
    std::array<const Bytes*, slot_count> slots{};
    const Bytes* operator[](Slot slot) const { return slots[static_cast<std::size_t>(slot)]; }
};

/// `dispatch`: dispatches of `schedule` (pass by pass) that have run since the substep began. 0 is the moment between
/// two substeps: then the sample is of the one that has just run, if one has; the buffers still hold all of it. Or of
/// the one to come, as far as somebody has filled keys and cells ahead of it. Nothing without positions.
std::optional<measure::BufferSample> make_sample(const SlotBytes& copies, const Schedule& schedule,
                                                 const SubstepParams<double>& params, std::uint32_t dispatch);

}  // namespace ballpit::app
