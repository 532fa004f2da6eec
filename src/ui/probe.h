// The views into grid, neighbours and buffers: what is open, and the plain data that they show.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/schedule.h"
#include "measure/ball_probe.h"
#include "measure/cell_table.h"

namespace ballpit::ui {

struct ProbeOptions {
    // Windows; a closed one costs nothing.
    bool follow = false;
    bool cells = false;
    bool buffers = false;
    bool split = false;  // brute force beside the grid

    // Drawn among the balls.
    bool contacts = false;
    bool arrows = false;
    float arrow_seconds = 0.2f;  // an arrow is the way in this time
    bool fade = true;            // balls that are not spoken of become see-through
    bool slice = false;
    int slice_axis = 2;             // 0, 1, 2: x, y, z
    std::uint32_t slice_layer = 0;  // clamped to the grid
    bool slice_cut = true;          // leave out what lies before the layer

    bool click_picks_cell = false;
    measure::CellOrder cell_order;
    Slot slot = Slot::positions;  // in the buffer tables
    double copies_a_second = 5.0;

    friend bool operator==(const ProbeOptions&, const ProbeOptions&) = default;
};

inline constexpr double slowest_copies = 0.5;
inline constexpr double fastest_copies = 30.0;
/// Cell widths that the split screen offers, in largest diameters.
inline constexpr double smallest_cell_factor = 0.5;
inline constexpr double largest_cell_factor = 4.0;

/// What a colour means.
struct LegendTick {
    float place = 0.0f;  // along the bar, 0 to 1
    std::string text;
};
struct LegendEntry {
    vec3 colour{1.0f};  // sRGB
    std::string text;
};
struct Legend {
    std::string title;
    std::vector<vec3> bar;  // colours evenly spaced; empty: entries alone
    std::vector<LegendTick> ticks;
    std::vector<LegendEntry> entries;
};

/// One of the two methods, side by side.
struct SplitSide {
    std::string title;
    bool known = false;  // the counts below have been taken
    std::uint64_t tested = 0;
    std::uint64_t contacts = 0;
    std::uint64_t missed = 0;
    std::optional<double> ms_per_substep;
};

/// Brings an element into sight once; another serial is another wish.
struct Jump {
    std::uint64_t element = 0;
    std::uint64_t serial = 0;
};

struct ProbeState {
    ProbeOptions options;
    std::uint32_t ball_count = 0;
    bool has_contacts = true;
    bool uses_grid = true;
    bool within_substep = false;  // some of its dispatches have run, others not

    std::optional<std::uint32_t> ball;
    std::optional<std::uint32_t> cell;
    const measure::BufferSample* sample = nullptr;  // null until the first copy has arrived
    const measure::BallProbe* follow = nullptr;     // of `ball`
    std::span<const std::uint32_t> cells;           // rows of the table of cells
    Jump cell_jump;                                 // an id
    uvec3 grid_cells{0};

    std::span<const std::byte> buffer;  // of options.slot; empty: none, or not there yet
    bool buffer_waiting = false;
    Jump buffer_jump;

    double age_s = 0.0;    // of the copies
    double cost_ms = 0.0;  // of what was worked out from them, on the CPU
    bool working = false;

    SplitSide grid_side;
    SplitSide brute_side;
    std::optional<double> apart;  // m, the most that a ball's two positions differ by

    std::span<const Legend> legends;
};

/// A number the reader can take in: three significant digits, e.g. "0.163", "1.2e-05".
std::string short_number(double value);

/// "4 402…4 417", or one number where the range has one element; `end` is one past the last.
std::string range_text(std::uint64_t first, std::uint64_t end);

/// Page of a table and row in it, for tables longer than a scroll bar can resolve.
inline constexpr std::uint64_t rows_a_page = 10000;
constexpr std::uint64_t page_of(std::uint64_t element) { return element / rows_a_page; }
constexpr std::uint64_t page_count(std::uint64_t elements) { return (elements + rows_a_page - 1) / rows_a_page; }

}  // namespace ballpit::ui
