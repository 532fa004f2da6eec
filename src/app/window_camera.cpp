#include "app/window_camera.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "view/picking.h"

namespace ballpit::app {

namespace {

constexpr float flight_s = 0.7f;

// From the middle of the window to the middle of what is free, as a share of its height (right, down). Each of two
// pictures has its own middle.
view::vec2 to_free_middle(const Surroundings& surroundings) {
    const WindowExtent& window = surroundings.extent;
    const float covered_width = surroundings.split ? 0.0f : window.width - window.free_width;
    return -0.5f * view::vec2(covered_width, window.height - window.free_height) / window.height;
}

}  // namespace

void WindowCamera::set_home(const Surroundings& surroundings) {
    const WindowExtent& window = surroundings.extent;
    const float free_width = surroundings.split ? 0.5f * window.free_width : window.free_width;
    camera_ = view::home(surroundings.half_extent, free_width / window.free_height);
    camera_.position *= window.height / window.free_height;
    camera_ = view::pan(camera_, to_free_middle(surroundings), surroundings.half_extent);
    home_ = camera_;
    home_surroundings_ = surroundings;
    flight_.reset();
}

bool WindowCamera::home_has_moved(const Surroundings& surroundings) const {
    const bool untouched =
        camera_.position == home_.position && camera_.yaw == home_.yaw && camera_.pitch == home_.pitch;
    const WindowExtent& now = surroundings.extent;
    const WindowExtent& then = home_surroundings_.extent;
    const bool other_panels = now.width - now.free_width != then.width - then.free_width ||
                              now.height - now.free_height != then.height - then.free_height;
    return surroundings.split != home_surroundings_.split || (untouched && other_panels);
}

void WindowCamera::look_from(const view::Camera& camera) {
    camera_ = camera;
    camera_.pitch = std::clamp(camera.pitch, -view::maximum_pitch, view::maximum_pitch);
    flight_.reset();
    to_home_ = false;
    placed_ = true;
}

void WindowCamera::fly_to(const vec4& ball, const Surroundings& surroundings) {
    view::Camera there = view::fly_to(camera_, vec3(ball), std::abs(ball.w));
    const float ahead = glm::dot(vec3(ball) - there.position, view::forward(there));
    const float picture_height = 2.0f * std::tan(0.5f * there.field_of_view) * ahead;  // m, at the ball
    const view::vec2 aside = picture_height * to_free_middle(surroundings);
    there.position += aside.y * view::up(there) - aside.x * view::right(there);
    flight_ = Flight{camera_, there, 0.0f};
}

void WindowCamera::update(Input& input, const Surroundings& surroundings, float seconds, bool typing, bool over_panel) {
    if (std::exchange(placed_, false)) {
        home_surroundings_ = surroundings;  // what opened with it is no reason to go home
    }
    if (std::exchange(to_home_, false) || home_has_moved(surroundings)) {
        set_home(surroundings);
    }
    if (input.active(typing)) {
        flight_.reset();
    }
    if (flight_) {
        flight_->seconds += seconds;
        camera_ = view::blend(flight_->from, flight_->to, flight_->seconds / flight_s);
        flight_ = flight_->seconds < flight_s ? flight_ : std::nullopt;
    }
    camera_ = input.moved(camera_, surroundings.half_extent, seconds, typing, over_panel);
}

}  // namespace ballpit::app
