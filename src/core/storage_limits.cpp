#include "core/storage_limits.h"

#include <algorithm>
#include <set>
#include <string>

#include "core/error.h"

namespace ballpit {

// Beyond what is guaranteed are only the slots of two options, so it is one of them that can be given up.
static std::string remedy(Slot last) {
    return last == Slot::built_positions ? "set grid_reuse (Grid reuse) to 1"
                                         : "switch off the law 'compensated' (Compensated sums)";
}

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
                              " a shader: " + remedy(*slots.rbegin()));
        }
    }
}

}  // namespace ballpit
