#include "app/window_overlay.h"

#include <algorithm>

namespace ballpit::app {

namespace {

constexpr vec4 selected_colour{1.0f, 0.85f, 0.2f, 1.0f};
constexpr float blink_hz = 1.5f;

}  // namespace

view::Overlay make_overlay(const ui::Inspection& inspection) {
    view::Overlay overlay;
    if (inspection.ball) {
        overlay.highlights.push_back({*inspection.ball, selected_colour, blink_hz});
    }
    overlay.cell = inspection.cell;
    return overlay;
}

bool blinks(const view::Overlay& overlay) {
    return std::ranges::any_of(overlay.highlights,
                               [](const view::BallHighlight& highlight) { return highlight.blink_hz > 0.0f; });
}

}  // namespace ballpit::app
