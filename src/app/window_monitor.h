// What the window knows of the buffers without ever waiting for them: what the status word counts, and how full the
// cells are.
#pragma once

#include <cstdint>
#include <optional>

#include "app/window_inspector.h"
#include "measure/occupancy.h"

namespace ballpit::app {

class Monitor {
public:
    /// Once a frame, before the inspector's update(). Cells are copied only while they are looked at.
    static void ask(Inspector& inspector, bool with_cells);
    /// Once a frame, after it.
    void update(const Inspector& inspector, std::uint32_t ball_count);

    const Status& status() const { return status_; }
    /// Null while no copy of the cells has arrived.
    const measure::Occupancy* occupancy() const { return occupancy_ ? &*occupancy_ : nullptr; }
    /// Balls in a cell that get the last colour: a power of two, so that colours do not flicker with the fullest cell.
    std::uint32_t top_count() const;

private:
    std::uint64_t cells_serial_ = 0;
    Status status_{};
    std::optional<measure::Occupancy> occupancy_;
};

}  // namespace ballpit::app
