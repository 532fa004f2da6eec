// Keys and mouse: events in, actions and camera motion out. What a key does is looked up in one place.
#pragma once

#include <SDL.h>

#include <optional>
#include <utility>

#include "core/vector.h"
#include "ui/action.h"
#include "ui/commands.h"
#include "view/camera.h"

namespace ballpit::app {

/// The action that a key press asks for, if any. By the letter printed on the key, whatever the keyboard's layout;
/// the brackets also by their place, since many layouts have none. A held key repeats only what steps.
std::optional<ui::Action> action_of(const SDL_Keysym& key, bool repeated);

class Input {
public:
    /// `typing`: a text field has the keyboard. `height`: of the window, points.
    void handle(const SDL_Event& event, bool typing, int height);

    /// The actions of the events since the last call.
    ui::Commands take_commands();

    /// Where the left button was pressed and released without a drag, beside the panels, since the last call (points).
    /// After moved(), which knows whose press it was.
    std::optional<view::vec2> take_click();

    /// With the hand tool the left button takes hold of things, and a click selects nothing.
    void set_hand(bool on) { hand_ = on; }
    /// Where the hand was closed since the last call, beside the panels (points). After moved().
    std::optional<view::vec2> take_press() { return std::exchange(press_, std::nullopt); }
    /// There was nothing to take hold of: this drag looks around, as without the hand.
    void let_look() { looking_ = true; }
    bool hand_closed() const { return hand_ && dragging_ == SDL_BUTTON_LEFT && !looking_; }
    /// Where the pointer is, points.
    const view::vec2& pointer() const { return pointer_; }

    /// The camera after this frame's motion and `seconds` of held keys; drags and wheel count once.
    /// `over_panel`: the pointer is on a panel, as the panels themselves say once they have seen this frame's events.
    view::Camera moved(view::Camera camera, const vec3& half_extent, float seconds, bool typing, bool over_panel);

    /// Whether a camera key is held or the pointer drags: the next frame will differ from this one.
    bool active(bool typing) const;

private:
    void handle_button(const SDL_MouseButtonEvent& button);
    void handle_motion(const SDL_MouseMotionEvent& motion, int height);
    void settle_claims(bool over_panel);

    ui::Commands commands_;
    Uint8 dragging_ = 0;      // mouse button; 0: none
    bool undecided_ = false;  // a drag began since the last frame, and may be a panel's
    int dragged_ = 0;         // points moved since the press
    std::optional<view::vec2> click_;
    bool hand_ = false;
    bool looking_ = true;  // what a drag with the left button does, unless a hand holds something
    std::optional<view::vec2> press_;
    view::vec2 pointer_{0.0f};
    view::vec2 look_{0.0f};
    view::vec2 pan_{0.0f};
    float notches_ = 0.0f;
};

}  // namespace ballpit::app
