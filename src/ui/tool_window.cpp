#include "ui/tool_window.h"

#include <algorithm>

#include "ui/panels.h"
#include "ui/stepping_panels.h"

namespace ballpit::ui {

ImVec2 free_room(const State& state) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float covered = state.view.panels ? side_panel_width() : 0.0f;
    return {std::max(display.x - covered, 20.0f * em()), display.y - strip_height(state)};
}

bool begin_tool_window(const State& state, const char* title, ImVec2 low, ImVec2 size, bool& open) {
    constexpr ImGuiWindowFlags flags =
        ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoCollapse;
    const float margin = window_margin();
    const ImVec2 room = free_room(state);
    size = ImVec2(std::min(size.x, room.x - 2.0f * margin), std::min(size.y, room.y - 2.0f * margin));
    low = ImVec2(std::clamp(low.x, margin, std::max(margin, room.x - size.x)),
                 std::clamp(low.y, margin, std::max(margin, room.y - size.y - margin)));
    ImGui::SetNextWindowPos(low, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize(size, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSizeConstraints(ImVec2(14.0f * em(), 8.0f * em()), ImVec2(FLT_MAX, FLT_MAX));
    return ImGui::Begin(title, &open, flags);
}

}  // namespace ballpit::ui
