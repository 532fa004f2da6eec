#include "app/window_monitor.h"

#include <algorithm>
#include <bit>

namespace ballpit::app {

namespace {

constexpr double cells_every_s = 0.1;

}  // namespace

void Monitor::update(Backend& backend, std::uint64_t revision, std::uint32_t ball_count, bool with_cells,
                     double now_s) {
    if (revision != revision_) {
        revision_ = revision;
        status_owed_ = 2;
        cells_owed_ = with_cells ? 2 : 0;
    }
    if (with_cells != had_cells_) {
        had_cells_ = with_cells;
        cells_owed_ = with_cells ? 2 : 0;
        occupancy_.reset();  // an old copy would show the wrong moment for some frames
    }
    if (const auto bytes = backend.poll(Slot::status); bytes && bytes->size() >= sizeof(Status)) {
        status_ = typed<Status>(*bytes).front();
        --status_owed_;
    }
    if (const auto bytes = backend.poll(Slot::cell_ranges)) {
        occupancy_ = measure::occupancy_of(typed<CellRange>(*bytes), std::size_t{ball_count} + 1);
        --cells_owed_;
    }
    if (status_owed_ > 0) {
        backend.request(Slot::status);
    }
    if (cells_owed_ > 0 && now_s - cells_asked_s_ >= cells_every_s) {
        cells_asked_s_ = now_s;
        backend.request(Slot::cell_ranges);
    }
}

std::uint32_t Monitor::top_count() const {
    constexpr std::uint32_t least = 8;
    constexpr std::uint32_t most = 1u << 30;
    return occupancy_ ? std::bit_ceil(std::clamp(occupancy_->max, least, most)) : least;
}

}  // namespace ballpit::app
