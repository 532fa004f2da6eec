// The eye of the window: at its home in front of the box, in the user's hand, or on its way to a ball.
#pragma once

#include <optional>

#include "app/input.h"
#include "app/window_extent.h"
#include "view/camera.h"

namespace ballpit::app {

/// What surrounds the eye in a frame.
struct Surroundings {
    WindowExtent extent;
    vec3 half_extent{1.0f};  // of the box, m
    bool split = false;      // two pictures side by side, each in a half of the free width
};

class WindowCamera {
public:
    const view::Camera& camera() const { return camera_; }

    void go_home() { to_home_ = true; }
    /// Stands there at once, and stays.
    void look_from(const view::Camera& camera);
    /// The ball (centre, radius) comes into the middle of what the panels leave free.
    void fly_to(const vec4& ball, const Surroundings& surroundings);
    bool flying() const { return flight_.has_value(); }

    /// Once a frame. What the hand does ends a flight; a camera that nobody has moved keeps the box in the middle when
    /// a panel opens.
    void update(Input& input, const Surroundings& surroundings, float seconds, bool typing, bool over_panel);

private:
    struct Flight {
        view::Camera from;
        view::Camera to;
        float seconds = 0.0f;
    };

    bool home_has_moved(const Surroundings& surroundings) const;
    void set_home(const Surroundings& surroundings);

    view::Camera camera_;
    view::Camera home_;
    Surroundings home_surroundings_;
    bool to_home_ = true;
    bool placed_ = false;  // by look_from, since the last update
    std::optional<Flight> flight_;
};

}  // namespace ballpit::app
