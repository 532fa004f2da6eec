// What the window knows of the buffers without ever waiting for them: copies are asked for, and looked at when they
// have arrived some frames later.
#pragma once

#include <cstdint>
#include <optional>

#include "core/backend.h"
#include "measure/occupancy.h"

namespace ballpit::app {

class Monitor {
public:
    /// Once a frame. `revision`: another number when the buffers have changed. Cells are copied only while they are
    /// looked at, and at most ten times a second.
    void update(Backend& backend, std::uint64_t revision, std::uint32_t ball_count, bool with_cells, double now_s);

    const Status& status() const { return status_; }
    /// Null while no copy of the cells has arrived.
    const measure::Occupancy* occupancy() const { return occupancy_ ? &*occupancy_ : nullptr; }
    /// Balls in a cell that get the last colour: a power of two, so that colours do not flicker with the fullest cell.
    std::uint32_t top_count() const;
    /// Whether a copy is still to come.
    bool waiting() const { return status_owed_ > 0 || cells_owed_ > 0; }

private:
    std::uint64_t revision_ = ~std::uint64_t{0};
    // Copies still to come: the first may have been asked for before the last change, the second was not.
    int status_owed_ = 0;
    int cells_owed_ = 0;
    double cells_asked_s_ = 0.0;
    bool had_cells_ = false;
    Status status_{};
    std::optional<measure::Occupancy> occupancy_;
};

}  // namespace ballpit::app
