// Play: balls that are thrown in, the hand that drags walls and balls, and shaking. What changes the run goes through
// the session's settings and added balls, so that it can be stepped back over and done again.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "app/input.h"
#include "app/play.h"
#include "app/window_extent.h"
#include "app/window_session.h"
#include "ui/action.h"
#include "ui/play.h"
#include "view/overlay.h"

namespace ballpit::app {

/// The eye, and the part of the window in which it shows the session's picture: all of it, or the left half of what is
/// free.
struct Eye {
    view::Camera camera;
    WindowExtent extent;
    bool split = false;

    /// Into the picture; nothing beside it. `point` of the window, points.
    std::optional<view::Ray> ray(const view::vec2& point) const;
    /// Through the middle of what the panels leave free.
    view::Ray middle() const;
};

class Play {
public:
    /// True where the action is one of play's. `pointer`: of the window, points; nothing where it is on a panel.
    bool act(ui::Action action, Session& session, const Eye& eye, const std::optional<view::vec2>& pointer);
    void choose(const ui::PlayOptions& options) { options_ = options; }

    /// Once a frame, when Input::moved() has settled whose the mouse is. A press reads the positions, and may wait for
    /// that.
    void update(Session& session, Input& input, const Eye& eye, bool over_panel);

    bool hand() const { return options_.hand; }
    /// The wall and the ball under the hand.
    void add_to(view::Overlay& overlay, const Session& session) const;
    const ui::PlayState& describe(const Session& session);
    std::string take_message() { return std::exchange(message_, {}); }

private:
    struct WallGrip {
        view::WallHit wall;
        double shift = 0.0;  // m, of the wall when it was taken
    };
    struct BallGrip {
        std::uint32_t ball = 0;
        vec3 centre{0.0f};  // when it was taken
    };
    using Grip = std::variant<std::monostate, WallGrip, BallGrip>;

    void shoot(Session& session, const view::Ray& ray);
    void add_cluster(Session& session, const view::Ray& ray);
    void toggle_shake(Session& session);
    void take_hold(Session& session, Input& input, const Eye& eye, const view::vec2& point);
    void drag(Session& session, const view::Ray& ray, const vec3& towards_eye) const;
    void let_go(Session& session);
    void follow_scene(const Session& session);

    ui::PlayOptions options_;
    ui::PlayOptions usual_;
    int scene_changes_ = -1;
    Grip grip_;
    std::optional<view::WallHit> hovered_;
    ui::PlayState state_;
    std::string message_;
};

}  // namespace ballpit::app
