#include "app/probe_overlay.h"

#include <algorithm>
#include <cmath>

#include "view/palette.h"

namespace ballpit::app {

void append_contacts(std::vector<view::LineSegment>& lines, const measure::BufferSample& sample,
                     const measure::FoundPairs& pairs, float top_overlap) {
    const std::vector<vec4>& shown = sample.shown();
    const std::size_t drawn = std::min(pairs.found.size(), most_contact_lines);
    for (std::size_t i = 0; i < drawn; ++i) {
        const auto [a, b] = pairs.found[i];
        const float overlap = measure::overlap_of(sample.positions[a], sample.positions[b]);
        const vec3 colour = view::sequential(top_overlap > 0.0f ? overlap / top_overlap : 0.0f);
        lines.push_back({vec3(shown[a]), vec3(shown[b]), vec4(colour, 1.0f), 4.0f});
    }
}

void append_missed_pairs(std::vector<view::LineSegment>& lines, const measure::BufferSample& sample,
                         const measure::FoundPairs& pairs) {
    const std::vector<vec4>& shown = sample.shown();
    const std::size_t drawn = std::min(pairs.missed.size(), most_contact_lines);
    for (std::size_t i = 0; i < drawn; ++i) {
        view::append_missed(lines, shown[pairs.missed[i].a], shown[pairs.missed[i].b]);
    }
}

void append_followed(view::Overlay& overlay, const Grid& grid, const measure::BallProbe& probe) {
    for (const std::uint32_t cell : probe.cells) {
        if (cell != probe.cell_id) {
            view::append_box(overlay.lines, view::cell_box(grid, cell), searched_colour, 1.0f);
        }
    }
    if (probe.cell_id && *probe.cell_id < grid.cell_count()) {
        view::append_box(overlay.lines, view::cell_box(grid, *probe.cell_id), chosen_colour, 2.5f);
    }
    for (const measure::NeighbourRow& row : probe.rows) {
        overlay.highlights.push_back({row.ball, row.touches ? touched_colour : tested_colour, 0.0f});
    }
}

void append_cell_balls(view::Overlay& overlay, const measure::BufferSample& sample, std::uint32_t cell) {
    for (const std::uint32_t ball : measure::balls_of_cell(sample, cell)) {
        overlay.highlights.push_back({ball, tested_colour, 0.0f});
    }
}

float round_up(float value) {
    if (!(value > 0.0f) || !std::isfinite(value)) {
        return 0.0f;
    }
    const float decade = std::pow(10.0f, std::floor(std::log10(value)));
    for (const float factor : {1.0f, 1.5f, 2.0f, 3.0f, 4.0f, 6.0f, 8.0f}) {
        if (value <= factor * decade * 1.0001f) {
            return factor * decade;
        }
    }
    return 10.0f * decade;
}

}  // namespace ballpit::app
