// What is drawn on top of the balls to look inside a step, as plain data: lines, marked balls, arrows, a slice through
// the grid. What is empty here costs nothing: no draw call, no upload.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/grid.h"
#include "core/vector.h"

namespace ballpit::view {

/// Colours: as on screen (sRGB), 0 to 1, and opacity.
struct LineSegment {
    vec3 from{0.0f};  // m
    vec3 to{0.0f};
    vec4 colour{1.0f};
    float width = 2.0f;   // pixels
    float hidden = 0.3f;  // share of its opacity where balls lie before it
    float lift = 0.0f;    // m nearer to the eye than it is, against what lies before it
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
    bool cut_away = true;     // leave out the balls that reach out of the layer towards the eye
};

/// A line from the middle of a ball, wherever it is now, to a point.
struct Tether {
    std::uint32_t ball = 0;
    vec3 target{0.0f};  // m
    vec4 colour{1.0f};
};

struct Overlay {
    std::vector<LineSegment> lines;
    std::vector<BallHighlight> highlights;  // balls beyond the count are ignored
    float fade_others = 0.0f;               // 0 to 1: how see-through the balls are that no highlight names
    float arrow_seconds = 0.0f;             // velocity arrows as long as the way in this time; 0: none
    std::optional<GridSlice> slice;
    std::optional<std::uint32_t> cell;  // cell id outlined strongly
    std::optional<Tether> tether;       // ignored beyond the count of balls

    bool empty() const {
        return lines.empty() && highlights.empty() && fade_others == 0.0f && arrow_seconds == 0.0f && !slice && !cell &&
               !tether;
    }
};

struct Box {
    vec3 low{0.0f};
    vec3 high{0.0f};
};
Box cell_box(const Grid& grid, std::uint32_t cell_id);

/// Where a layer's squares lie: on its side that faces the eye.
struct SlicePlane {
    vec3 normal{0.0f};   // towards the eye's side, along an axis
    float place = 0.0f;  // m: dot(normal, point) of the plane's points
};
/// Nothing where the grid has no such layer.
std::optional<SlicePlane> slice_plane(const Grid& grid, const GridSlice& slice, const vec3& eye);
/// Whether the slice leaves a ball (centre, radius) out.
bool is_cut_away(const GridSlice& slice, const SlicePlane& plane, const vec4& ball);

/// The twelve edges of a box.
void append_box(std::vector<LineSegment>& lines, const Box& box, const vec4& colour, float width = 2.0f);
/// The outline of one of its six faces: across `axis` 0, 1, 2, the upper or the lower one.
void append_face(std::vector<LineSegment>& lines, const Box& box, int axis, bool upper, const vec4& colour,
                 float width = 2.0f);
/// From centre to centre of two balls (centre, radius); sequential palette, `top_overlap` (m) gets its last colour.
/// Drawn on top of these two, and hardly seen through others: there are many.
void append_contact(std::vector<LineSegment>& lines, const vec4& a, const vec4& b, float top_overlap,
                    float width = 4.0f);
/// The same for a touching pair that the grid has missed: red, and well seen through others.
void append_missed(std::vector<LineSegment>& lines, const vec4& a, const vec4& b, float width = 5.0f);
/// A bow of many segments, `height` (m) higher in its middle than the straight line.
void append_arc(std::vector<LineSegment>& lines, const vec3& from, const vec3& to, float height, const vec4& colour,
                float width = 2.0f);

}  // namespace ballpit::view
