// A window with a title and a cross that stands where side panel and strip leave room at first, then wherever it is
// pulled to.
#pragma once

#include "ui/state.h"
#include "ui/style.h"

namespace ballpit::ui {

inline float window_margin() { return 0.6f * em(); }

/// Pixels that side panel and strip leave free, from the upper left corner.
ImVec2 free_room(const State& state);

/// Begins it; ImGui::End() follows in any case. `low` and `size` in pixels, for the first time it opens. `open` becomes
/// false where the cross was pressed. False: there is nothing to draw.
bool begin_tool_window(const State& state, const char* title, ImVec2 low, ImVec2 size, bool& open);

/// The same around `content`; false: the cross was pressed.
template <class Content>
bool tool_window(const State& state, const char* title, ImVec2 low, ImVec2 size, const Content& content) {
    bool open = true;
    if (begin_tool_window(state, title, low, size, open)) {
        content();
    }
    ImGui::End();
    return open;
}

}  // namespace ballpit::ui
