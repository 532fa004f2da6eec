#include "core/storage_limits.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <set>
#include <string>

#include "core/error.h"
#include "core/ledger.h"

namespace ballpit {

namespace {

// Beyond what is guaranteed are only the slots of two options, so it is one of them that can be given up.
std::string remedy(const std::set<Slot>& slots) {
    return slots.contains(Slot::built_positions) ? "set grid_reuse (Grid reuse) to 1"
                                                 : "switch off the law 'compensated' (Compensated sums)";
}

void expect_buffers(const Dispatch& dispatch, const StorageLimits& limits) {
    std::set<Slot> slots(dispatch.reads.begin(), dispatch.reads.end());
    slots.insert(dispatch.writes.begin(), dispatch.writes.end());
    if (slots.empty()) {
        return;
    }
    std::uint32_t last = 0;
    for (const Slot slot : slots) {
        last = std::max(last, binding_of(dispatch.program.shader, slot));
    }
    const std::uint32_t wanted = std::max(static_cast<std::uint32_t>(slots.size()), last + 1);
    if (slots.size() > limits.blocks || last >= limits.bindings) {
        throw NoRoom(dispatch.name + " would need " + std::to_string(wanted) + " buffers at once, the device allows " +
                     std::to_string(std::min(limits.blocks, limits.bindings)) + " a shader: " + remedy(slots));
    }
}

// The same schedule for other balls, as far as its bytes go.
Schedule with_balls(Schedule schedule, std::uint32_t balls) {
    schedule.ball_count = balls;
    schedule.key_count = schedule.key_count == 0 || balls == 0 ? 0 : std::bit_ceil(balls);
    schedule.cell_count = std::min(schedule.cell_count, maximum_cells(balls));
    return schedule;
}

bool fits(const Schedule& schedule, const StorageLimits& limits) {
    const auto bytes = bytes_of(schedule);
    const std::size_t sum = std::accumulate(bytes.begin(), bytes.end(), std::size_t{0});
    return *std::ranges::max_element(bytes) <= limits.block_bytes && (!limits.free_bytes || sum <= *limits.free_bytes);
}

std::string mebibytes(std::size_t bytes) { return std::to_string((bytes + (1u << 20) - 1) >> 20) + " MiB"; }

}  // namespace

std::uint32_t most_balls_that_fit(const Schedule& schedule, const StorageLimits& limits) {
    std::uint32_t low = 0;
    std::uint32_t high = schedule.ball_count;
    while (low < high) {
        const std::uint32_t middle = low + (high - low + 1) / 2;
        if (fits(with_balls(schedule, middle), limits)) {
            low = middle;
        } else {
            high = middle - 1;
        }
    }
    return low;
}

void expect_storage(const Schedule& schedule, const StorageLimits& limits) {
    for (const Dispatch& dispatch : schedule.dispatches) {
        expect_buffers(dispatch, limits);
    }
    if (fits(schedule, limits)) {
        return;
    }
    const auto bytes = bytes_of(schedule);
    const auto largest = std::ranges::max_element(bytes);
    const std::size_t sum = std::accumulate(bytes.begin(), bytes.end(), std::size_t{0});
    const std::string most = ": at most " + std::to_string(most_balls_that_fit(schedule, limits)) + " balls fit";
    const std::string balls = std::to_string(schedule.ball_count) + " balls would need ";
    if (*largest > limits.block_bytes) {
        const auto slot = static_cast<Slot>(largest - bytes.begin());
        throw NoRoom(balls + mebibytes(*largest) + " for buffer '" + std::string(slot_name(slot)) +
                     "', the device allows " + mebibytes(limits.block_bytes) + " a buffer" + most);
    }
    throw NoRoom(balls + mebibytes(sum) + " of the device's memory, of which " + mebibytes(*limits.free_bytes) +
                 " are free" + most);
}

}  // namespace ballpit
