#include "core/storage_limits.h"

#include <algorithm>
#include <set>
#include <string>

#include "core/error.h"

namespace ballpit {

// Without the law that keeps compensations no shader wants more than what is guaranteed, so it is the one to name.
void expect_storage(const Schedule& schedule, const StorageLimits& limits) {
    for (const Dispatch& dispatch : schedule.dispatches) {
        std::set<Slot> slots(dispatch.reads.begin(), dispatch.reads.end());
        slots.insert(dispatch.writes.begin(), dispatch.writes.end());
        if (slots.empty()) {
            continue;
        }
        const std::uint32_t last = static_cast<std::uint32_t>(*slots.rbegin());
        const std::uint32_t wanted = std::max(static_cast<std::uint32_t>(slots.size()), last + 1);
        const std::uint32_t allowed = std::min(limits.blocks, limits.bindings);
        if (slots.size() > limits.blocks || last >= limits.bindings) {
            throw DeviceError(dispatch.name + " would need " + std::to_string(wanted) +
                              " buffers at once, the device allows " + std::to_string(allowed) +
                              " a shader: switch off the law 'compensated' (Compensated sums)");
        }
    }
}

}  // namespace ballpit
