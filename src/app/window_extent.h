// The window in points, and what the panels leave free of it at the upper left.
#pragma once

namespace ballpit::app {

struct WindowExtent {
    float width = 1280.0f;
    float height = 720.0f;
    float free_width = 1280.0f;  // left of the side panel
    float free_height = 720.0f;  // above the strip and the microscope

    friend bool operator==(const WindowExtent&, const WindowExtent&) = default;
};

}  // namespace ballpit::app
