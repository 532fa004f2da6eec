#include "view/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "view/palette.h"

namespace ballpit::view {

Box cell_box(const Grid& grid, std::uint32_t cell_id) {
    const std::uint32_t row = cell_id / grid.cells.x;
    const dvec3 cell{cell_id % grid.cells.x, row % grid.cells.y, row / grid.cells.y};
    return {vec3(grid.origin + grid.cell_width * cell), vec3(grid.origin + grid.cell_width * (cell + 1.0))};
}

std::optional<SlicePlane> slice_plane(const Grid& grid, const GridSlice& slice, const vec3& eye) {
    if (slice.axis < 0 || slice.axis > 2 || slice.layer >= grid.cells[slice.axis]) {
        return std::nullopt;
    }
    const double middle = grid.origin[slice.axis] + grid.cell_width * (slice.layer + 0.5);
    const double side = eye[slice.axis] < middle ? -1.0 : 1.0;
    SlicePlane plane;
    plane.normal[slice.axis] = static_cast<float>(side);
    plane.place = static_cast<float>(side * middle + 0.5 * grid.cell_width);
    return plane;
}

bool is_cut_away(const GridSlice& slice, const SlicePlane& plane, const vec4& ball) {
    return slice.cut_away && glm::dot(plane.normal, vec3(ball)) + ball.w > plane.place;
}

void append_box(std::vector<LineSegment>& lines, const Box& box, const vec4& colour, float width) {
    constexpr std::array<glm::uvec2, 4> sides = {glm::uvec2(0, 0), glm::uvec2(0, 1), glm::uvec2(1, 0),
                                                 glm::uvec2(1, 1)};
    const std::array<vec3, 2> corners = {box.low, box.high};
    for (int axis = 0; axis < 3; ++axis) {
        const int second = (axis + 1) % 3;
        const int third = (axis + 2) % 3;
        for (const glm::uvec2& side : sides) {
            LineSegment line{box.low, box.low, colour, width};
            line.from[second] = line.to[second] = corners[side.x][second];
            line.from[third] = line.to[third] = corners[side.y][third];
            line.to[axis] = box.high[axis];
            lines.push_back(line);
        }
    }
}

void append_face(std::vector<LineSegment>& lines, const Box& box, int axis, bool upper, const vec4& colour,
                 float width) {
    const int second = (axis + 1) % 3;
    const int third = (axis + 2) % 3;
    std::array<vec3, 4> corners{};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        corners[i][axis] = upper ? box.high[axis] : box.low[axis];
        corners[i][second] = i == 1 || i == 2 ? box.high[second] : box.low[second];
        corners[i][third] = i >= 2 ? box.high[third] : box.low[third];
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
        lines.push_back({corners[i], corners[(i + 1) % corners.size()], colour, width});
    }
}

void append_contact(std::vector<LineSegment>& lines, const vec4& a, const vec4& b, float top_overlap, float width) {
    constexpr float hidden = 0.04f;
    constexpr float clearance = 1.05f;
    const float overlap = a.w + b.w - glm::distance(vec3(a), vec3(b));
    const vec3 colour = sequential(overlap / std::max(top_overlap, 1e-30f));
    lines.push_back({vec3(a), vec3(b), vec4(colour, 1.0f), width, hidden, clearance * std::max(a.w, b.w)});
}

void append_missed(std::vector<LineSegment>& lines, const vec4& a, const vec4& b, float width) {
    constexpr float hidden = 0.6f;
    constexpr vec4 red{1.0f, 0.13f, 0.10f, 1.0f};
    lines.push_back({vec3(a), vec3(b), red, width, hidden, std::max(a.w, b.w)});
}

void append_arc(std::vector<LineSegment>& lines, const vec3& from, const vec3& to, float height, const vec4& colour,
                float width) {
    constexpr int segments = 24;
    const auto point = [&](int i) {
        const float t = static_cast<float>(i) / static_cast<float>(segments);
        return glm::mix(from, to, t) + vec3(0.0f, 0.0f, 4.0f * height * t * (1.0f - t));
    };
    for (int i = 0; i < segments; ++i) {
        lines.push_back({point(i), point(i + 1), colour, width});
    }
}

}  // namespace ballpit::view
