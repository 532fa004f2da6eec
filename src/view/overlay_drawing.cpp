#include "view/overlay_drawing.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "core/layout.h"
#include "view/frame.h"
#include "view/view_program.h"

namespace ballpit::view {

namespace {

constexpr vec4 selection_colour{1.0f, 1.0f, 1.0f, 1.0f};
constexpr float selection_width = 4.0f;

void make_room(gl::Buffer& buffer, const char* label, std::size_t bytes) {
    if (buffer.size() < bytes) {
        buffer = gl::Buffer(label, bytes + bytes / 2, GL_STREAM_DRAW);
    }
}

// Never quite gone: a paused glance must find it.
float blink(float hz, float time_s) {
    constexpr float dimmest = 0.15f;
    const float phase = 2.0f * std::numbers::pi_v<float> * std::fmod(hz * time_s, 1.0f);
    return dimmest + (1.0f - dimmest) * (0.5f + 0.5f * std::cos(phase));
}

void draw_squares(const gl::Program& program, const gl::VertexArray& array, std::size_t count, bool through) {
    program.use();
    glUniform1i(program.uniform("through"), through ? 1 : 0);
    array.bind();
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(count));
}

}  // namespace

OverlayDrawing::OverlayDrawing(const std::filesystem::path& shader_folder)
    : line_program_(load_view_program(shader_folder, "line")),
      highlight_program_(load_view_program(shader_folder, "highlight")),
      slice_program_(load_view_program(shader_folder, "slice")),
      tether_program_(load_view_program(shader_folder, "line", {"TETHER"})),
      readable_elements_(gl::BufferTexture::capacity()) {}

void OverlayDrawing::prepare(const Picture& picture) {
    lines_ = rings_ = slice_cells_ = 0;
    tethered_ = false;
    if (picture.overlay == nullptr) {
        return;
    }
    prepare_lines(picture);
    prepare_rings(picture);
    const std::optional<Tether>& tether = picture.overlay->tether;
    tethered_ = tether && tether->ball < std::min<std::size_t>(picture.ball_count, readable_elements_);
    const std::optional<GridSlice>& slice = picture.overlay->slice;
    const Grid& grid = picture.grid;
    if (slice && picture.cell_ranges != nullptr && grid.cell_count() <= readable_elements_ &&
        slice_plane(grid, *slice, picture.camera.position)) {
        assert(picture.cell_ranges->size() >= grid.cell_count() * sizeof(CellRange));
        slice_cells_ = grid.cell_count() / grid.cells[slice->axis];
    }
}

void OverlayDrawing::prepare_lines(const Picture& picture) {
    const std::vector<LineSegment>& lines = picture.overlay->lines;
    const std::optional<std::uint32_t>& cell = picture.overlay->cell;
    std::vector<LineSegment> selection;
    if (cell && *cell < picture.grid.cell_count()) {
        append_box(selection, cell_box(picture.grid, *cell), selection_colour, selection_width);
    }
    lines_ = lines.size() + selection.size();
    if (lines_ == 0) {
        return;
    }
    const auto bytes = std::as_bytes(std::span(lines));
    make_room(line_buffer_, "overlay lines", lines_ * sizeof(LineSegment));
    line_buffer_.write(bytes);
    line_buffer_.write(std::as_bytes(std::span(selection)), bytes.size());
    constexpr GLsizei stride = sizeof(LineSegment);
    line_array_.floats(0, line_buffer_, 3, stride, offsetof(LineSegment, from), 1);
    line_array_.floats(1, line_buffer_, 3, stride, offsetof(LineSegment, to), 1);
    line_array_.floats(2, line_buffer_, 4, stride, offsetof(LineSegment, colour), 1);
    line_array_.floats(3, line_buffer_, 1, stride, offsetof(LineSegment, width), 1);
    line_array_.floats(4, line_buffer_, 1, stride, offsetof(LineSegment, hidden), 1);
    line_array_.floats(5, line_buffer_, 1, stride, offsetof(LineSegment, lift), 1);
}

void OverlayDrawing::prepare_rings(const Picture& picture) {
    const std::size_t balls = std::min<std::size_t>(picture.ball_count, readable_elements_);
    std::vector<Ring> rings;
    for (const BallHighlight& highlight : picture.overlay->highlights) {
        if (highlight.ball < balls) {
            rings.push_back({highlight.ball, highlight.colour});
            rings.back().colour.a *= blink(highlight.blink_hz, picture.time_s);
        }
    }
    rings_ = rings.size();
    if (rings_ == 0) {
        return;
    }
    const auto bytes = std::as_bytes(std::span(rings));
    make_room(ring_buffer_, "overlay highlights", bytes.size());
    ring_buffer_.write(bytes);
    ring_array_.uints(0, ring_buffer_, 1, sizeof(Ring), offsetof(Ring, ball), 1);
    ring_array_.floats(1, ring_buffer_, 4, sizeof(Ring), offsetof(Ring, colour), 1);
}

void OverlayDrawing::draw_tether(const Tether& tether, bool through) {
    tether_program_.use();
    glUniform1ui(tether_program_.uniform("ball_id"), tether.ball);
    glUniform3fv(tether_program_.uniform("target"), 1, &tether.target.x);
    glUniform4fv(tether_program_.uniform("tether_colour"), 1, &tether.colour.x);
    draw_squares(tether_program_, no_attributes_, 1, through);
}

void OverlayDrawing::draw(const Picture& picture, bool through) {
    if (lines_ + rings_ + slice_cells_ == 0 && !tethered_) {
        return;
    }
    (through ? glDisable : glEnable)(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    glDepthMask(GL_FALSE);
    if (slice_cells_ != 0) {
        elements_.bind(unit_elements, *picture.cell_ranges, GL_RG32UI);
        draw_squares(slice_program_, no_attributes_, slice_cells_, through);
    }
    if (lines_ != 0) {
        draw_squares(line_program_, line_array_, lines_, through);
    }
    if (rings_ != 0) {
        elements_.bind(unit_elements, *picture.positions, GL_RGBA32F);
        draw_squares(highlight_program_, ring_array_, rings_, through);
    }
    if (tethered_) {
        elements_.bind(unit_elements, *picture.positions, GL_RGBA32F);
        draw_tether(*picture.overlay->tether, through);
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

}  // namespace ballpit::view
