// Where the windows that look inside stand: beside each other at first, then wherever they are pulled to.
#include <algorithm>
#include <array>

#include "ui/panels.h"
#include "ui/probe_panels.h"
#include "ui/stepping_panels.h"
#include "ui/style.h"

namespace ballpit::ui {

namespace {

constexpr ImGuiWindowFlags movable =
    ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoCollapse;
constexpr ImGuiWindowFlags fixed = movable | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoTitleBar |
                                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                   ImGuiWindowFlags_AlwaysAutoResize;

float margin() { return 0.6f * em(); }

// What side panel and strip leave free.
ImVec2 free_room(const State& state) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float covered = state.view.panels ? side_panel_width() : 0.0f;
    return {std::max(display.x - covered, 20.0f * em()), display.y - strip_height(state)};
}

// A window with a title and a cross; `low` and `size` in pixels, for the first time it opens.
template <class Content>
bool window(const State& state, const char* title, ImVec2 low, ImVec2 size, const Content& content) {
    const ImVec2 room = free_room(state);
    size = ImVec2(std::min(size.x, room.x - 2.0f * margin()), std::min(size.y, room.y - 2.0f * margin()));
    low = ImVec2(std::clamp(low.x, margin(), std::max(margin(), room.x - size.x)),
                 std::clamp(low.y, margin(), std::max(margin(), room.y - size.y - margin())));
    ImGui::SetNextWindowPos(low, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize(size, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSizeConstraints(ImVec2(14.0f * em(), 8.0f * em()), ImVec2(FLT_MAX, FLT_MAX));
    bool open = true;
    if (ImGui::Begin(title, &open, movable)) {
        content();
    }
    ImGui::End();
    return open;
}

void close(const State& state, bool ProbeOptions::*which, Commands& commands) {
    ProbeOptions options = state.probe->options;
    options.*which = false;
    commands.push_back(ChangeProbe{options});
}

void tool_windows(const State& state, Commands& commands) {
    const ProbeOptions& options = state.probe->options;
    const ImVec2 room = free_room(state);
    const float below_rate = 6.0f * em();
    if (options.cells && !window(state, "Cells", ImVec2(margin(), below_rate),
                                 ImVec2(27.0f * em(), room.y - below_rate), [&] { cells_panel(state, commands); })) {
        close(state, &ProbeOptions::cells, commands);
    }
    if (options.buffers && !window(state, "Buffers", ImVec2(room.x - 32.0f * em(), margin()),
                                   ImVec2(32.0f * em(), 19.0f * em()), [&] { buffers_panel(state, commands); })) {
        close(state, &ProbeOptions::buffers, commands);
    }
    if (options.follow && !window(state, "Follow one ball", ImVec2(margin(), below_rate), ImVec2(room.x, 15.0f * em()),
                                  [&] { follow_panel(state, commands); })) {
        close(state, &ProbeOptions::follow, commands);
    }
}

void legend_window(const State& state) {
    if (state.probe->legends.empty()) {
        return;
    }
    const ImVec2 room = free_room(state);
    const bool split = state.probe->options.split;  // then the corner is taken
    const float y = split ? margin() : room.y - margin();
    ImGui::SetNextWindowPos(ImVec2(room.x, y), ImGuiCond_Always, ImVec2(1.0f, split ? 0.0f : 1.0f));
    ImGui::Begin("legend", nullptr, fixed);
    for (std::size_t i = 0; i < state.probe->legends.size(); ++i) {
        if (i > 0) {
            ImGui::Spacing();
        }
        legend_panel(state.probe->legends[i]);
    }
    ImGui::End();
}

void split_windows(const State& state, Commands& commands) {
    const ImVec2 room = free_room(state);
    const std::array<const SplitSide*, 2> sides = {&state.probe->grid_side, &state.probe->brute_side};
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const float middle = room.x * (0.25f + 0.5f * static_cast<float>(i));
        ImGui::SetNextWindowPos(ImVec2(middle, room.y - margin() - hash_corner_height(state)), ImGuiCond_Always,
                                ImVec2(0.5f, 1.0f));
        ImGui::Begin(i == 0 ? "grid side" : "brute force side", nullptr, fixed);
        split_counts(*sides[i]);
        ImGui::End();
    }
    ImGui::SetNextWindowPos(ImVec2(0.5f * room.x, 6.0f * em()), ImGuiCond_Always, ImVec2(0.5f, 0.0f));
    ImGui::Begin("split", nullptr, fixed);
    split_panel(state, commands);
    ImGui::End();
}

}  // namespace

void draw_probe_windows(const State& state, Commands& commands) {
    if (state.probe->options.split) {
        split_windows(state, commands);
    }
    tool_windows(state, commands);
    legend_window(state);
}

}  // namespace ballpit::ui
