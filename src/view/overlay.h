// What is drawn on top of the balls to look inside a step, as plain data: lines, marked balls, arrows, a slice through
// the grid. What is empty here costs nothing: no draw call, no upload.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/grid.h"
#include "core/vector.h"

namespace ballpit::view {

/// Colours: as on screen (sRGB), 0 to 1, and opacity. Seen through balls, faintly.
struct LineSegment {
    vec3 from{0.0f};  // m
    vec3 to{0.0f};
    vec4 colour{1.0f};
    float width = 2.0f;  // pixels
};

/// A ring round a ball that is also seen through the balls before it.
struct BallHighlight {
    std::uint32_t ball = 0;
    vec4 colour{1.0f};
    float blink_hz = 0.0f;  // 0: steady
};

/// One layer of cells as a heat map: each a translucent square, coloured by how many balls it holds.
struct GridSlice {
    int axis = 2;             // 0, 1, 2: across x, y, z
    std::uint32_t layer = 0;  // along that axis; one beyond the grid shows nothing
    bool cut_away = true;     // leave out the balls between the layer and the eye
};

struct Overlay {
    std::vector<LineSegment> lines;
    std::vector<BallHighlight> highlights;  // balls beyond the count are ignored
    float fade_others = 0.0f;               // 0 to 1: how see-through the balls are that no highlight names
    float arrow_seconds = 0.0f;             // velocity arrows as long as the way in this time; 0: none
    std::optional<GridSlice> slice;
    std::optional<std::uint32_t> cell;  // cell id outlined strongly

    bool empty() const {
        return lines.empty() && highlights.empty() && fade_others == 0.0f && arrow_seconds == 0.0f && !slice && !cell;
    }
};

struct Box {
    vec3 low{0.0f};
    vec3 high{0.0f};
};
Box cell_box(const Grid& grid, std::uint32_t cell_id);

/// m along the slice's axis: the side of the layer that faces the eye, where its squares lie.
float slice_place(const Grid& grid, const GridSlice& slice, const vec3& eye);

/// The twelve edges of a box.
void append_box(std::vector<LineSegment>& lines, const Box& box, const vec4& colour, float width = 2.0f);
/// From centre to centre of two balls (centre, radius); sequential palette, `top_overlap` (m) gets its last colour.
void append_contact(std::vector<LineSegment>& lines, const vec4& a, const vec4& b, float top_overlap,
                    float width = 4.0f);
/// The same for a touching pair that the grid has missed: red.
void append_missed(std::vector<LineSegment>& lines, const vec4& a, const vec4& b, float width = 5.0f);
/// A bow of many segments, `height` (m) higher in its middle than the straight line.
void append_arc(std::vector<LineSegment>& lines, const vec3& from, const vec3& to, float height, const vec4& colour,
                float width = 2.0f);

}  // namespace ballpit::view
