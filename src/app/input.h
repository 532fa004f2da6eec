// Keys and mouse: events in, actions and camera motion out. What a key does is looked up in one place.
#pragma once

#include <SDL.h>

#include <optional>

#include "core/vector.h"
#include "ui/action.h"
#include "ui/commands.h"
#include "view/camera.h"

namespace ballpit::app {

/// The action that a key press asks for, if any. By the letter printed on the key, whatever the keyboard's layout;
/// the brackets also by their place, since many layouts have none. A held key repeats only the single step.
std::optional<ui::Action> action_of(const SDL_Keysym& key, bool repeated);

class Input {
public:
    /// `typing`: a text field has the keyboard. `over_panel`: the pointer is on a panel. `height`: of the window,
    /// points.
    void handle(const SDL_Event& event, bool typing, bool over_panel, int height);

    /// The actions of the events since the last call.
    ui::Commands take_commands();

    /// The camera after this frame's motion and `seconds` of held keys; drags and wheel count once.
    view::Camera moved(view::Camera camera, const vec3& half_extent, float seconds, bool typing);

    /// Whether a camera key is held or the pointer drags: the next frame will differ from this one.
    bool active(bool typing) const;

private:
    void handle_button(const SDL_MouseButtonEvent& button, bool over_panel);
    void handle_motion(const SDL_MouseMotionEvent& motion, int height);

    ui::Commands commands_;
    Uint8 dragging_ = 0;  // mouse button that went down beside the panels; 0: none
    view::vec2 look_{0.0f};
    view::vec2 pan_{0.0f};
    float notches_ = 0.0f;
};

}  // namespace ballpit::app
