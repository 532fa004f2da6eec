// What the views into grid and neighbours draw among the balls.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/probe_work.h"
#include "view/overlay.h"

namespace ballpit::app {

inline constexpr vec4 touched_colour{0.90f, 0.45f, 0.10f, 1.0f};  // after Okabe and Ito: vermilion, sky blue
inline constexpr vec4 tested_colour{0.34f, 0.71f, 0.91f, 1.0f};
inline constexpr vec4 searched_colour{0.75f, 0.80f, 0.86f, 0.45f};
inline constexpr vec4 chosen_colour{1.0f, 0.85f, 0.2f, 1.0f};
inline constexpr vec4 missed_colour{1.0f, 0.13f, 0.10f, 1.0f};
/// More lines than anyone could tell apart.
inline constexpr std::size_t most_contact_lines = 200000;

/// Lines from centre to centre where the balls are drawn, coloured by the overlap that collide saw; missed pairs red.
void append_contacts(std::vector<view::LineSegment>& lines, const measure::BufferSample& sample,
                     const measure::FoundPairs& pairs, float top_overlap);
void append_missed_pairs(std::vector<view::LineSegment>& lines, const measure::BufferSample& sample,
                         const measure::FoundPairs& pairs);

/// The cells looked through, and a ring round each ball tested.
void append_followed(view::Overlay& overlay, const Grid& grid, const measure::BallProbe& probe);

/// A ring round each ball of a cell.
void append_cell_balls(view::Overlay& overlay, const measure::BufferSample& sample, std::uint32_t cell);

/// The next larger round number: a range that does not flicker. 0 gives 0.
float round_up(float value);

}  // namespace ballpit::app
