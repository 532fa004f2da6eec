#include "app/window_monitor.h"

#include <algorithm>
#include <bit>

namespace ballpit::app {

void Monitor::ask(Inspector& inspector, bool with_cells) {
    inspector.want_late(Slot::status);
    if (with_cells) {
        inspector.want_late(Slot::cell_ranges);
    }
}

void Monitor::update(const Inspector& inspector, std::uint32_t ball_count) {
    const Bytes* status = inspector.bytes(Slot::status);
    if (status != nullptr && status->size() >= sizeof(Status)) {
        status_ = typed<Status>(*status).front();
    }
    const Bytes* cells = inspector.bytes(Slot::cell_ranges);
    if (cells == nullptr) {
        occupancy_.reset();
    } else if (cells_serial_ != inspector.serial(Slot::cell_ranges)) {
        cells_serial_ = inspector.serial(Slot::cell_ranges);
        occupancy_ = measure::occupancy_of(typed<CellRange>(*cells), std::size_t{ball_count} + 1);
    }
}

std::uint32_t Monitor::top_count() const {
    constexpr std::uint32_t least = 8;
    constexpr std::uint32_t most = 1u << 30;
    return occupancy_ ? std::bit_ceil(std::clamp(occupancy_->max, least, most)) : least;
}

}  // namespace ballpit::app
