#include "app/window_play.h"

#include <algorithm>

#include "app/room.h"
#include "ui/widgets.h"
#include "view/picking.h"

namespace ballpit::app {

namespace {

constexpr vec4 hovered_colour{1.0f, 0.85f, 0.2f, 0.7f};
constexpr vec4 held_colour{1.0f, 0.85f, 0.2f, 1.0f};
constexpr double farthest_wall = 100.0;  // m: range of walls_low and walls_high
constexpr double farthest_target = 1e4;  // m: range of a pull's target

dvec3& wall_of(Settings& settings, bool upper) { return upper ? settings.walls_high : settings.walls_low; }

std::vector<vec4> positions_of(Session& session) {
    return read_slot<vec4>(session.simulation().backend(), Slot::positions);
}

}  // namespace

std::optional<view::Ray> Eye::ray(const view::vec2& point) const {
    const float width = split ? 0.5f * extent.free_width : extent.width;
    if (point.x < 0.0f || point.x >= width || point.y < 0.0f || point.y >= extent.height) {
        return std::nullopt;
    }
    return view::ray_through(camera, width / extent.height, {point.x / width, point.y / extent.height});
}

view::Ray Eye::middle() const {
    const float width = split ? 0.5f * extent.free_width : extent.free_width;
    const auto ray = this->ray({0.5f * width, 0.5f * extent.free_height});
    return ray.value_or(view::Ray{camera.position, view::forward(camera)});
}

bool Play::act(ui::Action action, Session& session, const Eye& eye, const std::optional<view::vec2>& pointer) {
    follow_scene(session);
    const auto pointed = pointer ? eye.ray(*pointer) : std::nullopt;
    const view::Ray ray = pointed.value_or(eye.middle());
    switch (action) {
        case ui::Action::shoot_ball:
            shoot(session, ray);
            return true;
        case ui::Action::add_cluster:
            add_cluster(session, ray);
            return true;
        case ui::Action::toggle_hand:
            options_.hand = !options_.hand;
            return true;
        case ui::Action::toggle_shake:
            toggle_shake(session);
            return true;
        default:
            return false;
    }
}

void Play::shoot(Session& session, const view::Ray& ray) {
    const view::Box box = drawn_box(session.simulation());
    if (const auto ball = shot(ray, box, options_, positions_of(session))) {
        session.add_balls({*ball});
    } else {
        message_ = view::span_in(ray, box) ? "There is no room for the ball on that line."
                                           : "A ball starts where the line of sight enters the box: point there.";
    }
}

void Play::add_cluster(Session& session, const view::Ray& ray) {
    const view::Box box = drawn_box(session.simulation());
    std::vector<BallSpec> balls = cluster(ray, box, options_, positions_of(session));
    if (balls.empty()) {
        message_ = view::span_in(ray, box) ? "There is no room for a ball on that line."
                                           : "A cluster is put on the line of sight through the box: point there.";
        return;
    }
    const std::size_t found = balls.size();
    if (session.add_balls(std::move(balls)) && found < options_.cluster) {
        message_ = "There was room for " + ui::grouped(found) + " of " + ui::grouped(options_.cluster) + " balls.";
    }
}

void Play::toggle_shake(Session& session) {
    Settings settings = session.wanted();
    if (!settings.laws.walls) {
        message_ = "Shaking needs walls, and this scene has none: tick Walls among its laws (F4).";
        return;
    }
    settings.laws.shake = !settings.laws.shake;
    session.want(settings);
}

void Play::follow_scene(const Session& session) {
    if (scene_changes_ != session.scene_changes()) {
        scene_changes_ = session.scene_changes();
        const bool hand = options_.hand;
        const std::uint32_t cluster = options_.cluster;
        usual_ = options_ = usual_play(session.simulation().scene());
        options_.hand = hand;
        options_.cluster = cluster;
        grip_ = {};
    }
}

void Play::update(Session& session, Input& input, const Eye& eye, bool over_panel) {
    follow_scene(session);
    input.set_hand(options_.hand);
    if (const auto press = input.take_press()) {
        take_hold(session, input, eye, *press);
    }
    const auto ray = eye.ray(input.pointer());
    hovered_.reset();
    if (!input.hand_closed()) {
        let_go(session);
        if (options_.hand && !over_panel && ray && session.wanted().laws.walls) {
            hovered_ = view::pick_wall(*ray, drawn_box(session.simulation()));
        }
    } else if (ray) {
        drag(session, *ray, -view::forward(eye.camera));
    }
}

void Play::take_hold(Session& session, Input& input, const Eye& eye, const view::vec2& point) {
    const auto ray = eye.ray(point);
    const Simulation& simulation = session.simulation();
    if (!ray) {
        input.let_look();
        return;
    }
    const float width = eye.split ? 0.5f * eye.extent.free_width : eye.extent.width;
    const std::vector<vec4> positions = positions_of(session);
    const auto ball = view::pick_ball(eye.camera, room_half_extent(simulation), width / eye.extent.height,
                                      {point.x / width, point.y / eye.extent.height}, positions);
    if (ball) {
        grip_ = BallGrip{*ball, vec3(positions[*ball])};
        return;
    }
    const auto wall = view::pick_wall(*ray, drawn_box(simulation));
    if (!wall) {
        input.let_look();
    } else if (!session.wanted().laws.walls) {
        message_ = "This scene has no walls to drag: tick Walls among its laws (F4).";
        input.let_look();
    } else {
        const WallShift& shift = simulation.wall_shift();
        grip_ = WallGrip{*wall, (wall->upper ? shift.high : shift.low)[wall->axis]};
    }
}

// Only what the hand is at is wanted anew: everything else stays as it is wanted.
void Play::drag(Session& session, const view::Ray& ray, const vec3& towards_eye) const {
    Settings settings = session.wanted();
    if (const auto* wall = std::get_if<WallGrip>(&grip_)) {
        if (const auto along = view::drag_along(ray, wall->wall.point, wall->wall.axis)) {
            wall_of(settings, wall->wall.upper)[wall->wall.axis] =
                std::clamp(wall->shift + static_cast<double>(*along), -farthest_wall, farthest_wall);
        }
    } else if (const auto* ball = std::get_if<BallGrip>(&grip_)) {
        if (const auto target = view::drag_across(ray, ball->centre, towards_eye)) {
            settings.pull = Pull{ball->ball, glm::clamp(dvec3(*target), -farthest_target, farthest_target)};
        }
    }
    session.want(settings);
}

void Play::let_go(Session& session) {
    if (std::holds_alternative<BallGrip>(grip_)) {
        Settings settings = session.wanted();
        settings.pull.reset();
        session.want(settings);
    }
    grip_ = {};
}

void Play::add_to(view::Overlay& overlay, const Session& session) const {
    const view::Box box = drawn_box(session.simulation());
    const auto* held = std::get_if<WallGrip>(&grip_);
    if (held != nullptr) {
        view::append_face(overlay.lines, box, held->wall.axis, held->wall.upper, held_colour, 3.0f);
        Settings wanted = session.wanted();
        const Box& scene_box = session.simulation().scene_box();
        const double start = (held->wall.upper ? scene_box.upper : scene_box.lower)[held->wall.axis];
        const double place = start + wall_of(wanted, held->wall.upper)[held->wall.axis];
        view::Box target = box;
        (held->wall.upper ? target.high : target.low)[held->wall.axis] = static_cast<float>(place);
        view::append_face(overlay.lines, target, held->wall.axis, held->wall.upper, hovered_colour, 1.5f);
    } else if (hovered_) {
        view::append_face(overlay.lines, box, hovered_->axis, hovered_->upper, hovered_colour, 2.0f);
    }
    if (const auto& pull = session.simulation().settings().pull) {
        overlay.highlights.push_back({pull->ball, held_colour, 0.0f});
        overlay.tether = view::Tether{pull->ball, vec3(pull->target), held_colour};
    }
}

const ui::PlayState& Play::describe(const Session& session) {
    follow_scene(session);
    const auto& pull = session.simulation().settings().pull;
    state_.options = options_;
    state_.usual = usual_;
    state_.walls_moved = session.wanted().walls_low != dvec3(0.0) || session.wanted().walls_high != dvec3(0.0);
    state_.held_ball = pull ? std::optional(pull->ball) : std::nullopt;
    return state_;
}

}  // namespace ballpit::app
