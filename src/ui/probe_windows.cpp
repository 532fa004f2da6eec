// Where the windows that look inside stand: beside each other at first, then wherever they are pulled to.
#include <array>

#include "ui/panels.h"
#include "ui/probe_panels.h"
#include "ui/tool_window.h"

namespace ballpit::ui {

namespace {

constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoTitleBar |
                                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                   ImGuiWindowFlags_AlwaysAutoResize;

void close(const State& state, bool ProbeOptions::*which, Commands& commands) {
    ProbeOptions options = state.probe->options;
    options.*which = false;
    commands.push_back(ChangeProbe{options});
}

void tool_windows(const State& state, Commands& commands) {
    const ProbeOptions& options = state.probe->options;
    const ImVec2 room = free_room(state);
    const float below_rate = 6.0f * em();
    if (options.cells &&
        !tool_window(state, "Cells", ImVec2(window_margin(), below_rate), ImVec2(27.0f * em(), room.y - below_rate),
                     [&] { cells_panel(state, commands); })) {
        close(state, &ProbeOptions::cells, commands);
    }
    if (options.buffers && !tool_window(state, "Buffers", ImVec2(room.x - 32.0f * em(), window_margin()),
                                        ImVec2(32.0f * em(), 19.0f * em()), [&] { buffers_panel(state, commands); })) {
        close(state, &ProbeOptions::buffers, commands);
    }
    if (options.follow && !tool_window(state, "Follow one ball", ImVec2(window_margin(), below_rate),
                                       ImVec2(room.x, 15.0f * em()), [&] { follow_panel(state, commands); })) {
        close(state, &ProbeOptions::follow, commands);
    }
}

void legend_window(const State& state) {
    if (state.probe->legends.empty()) {
        return;
    }
    const ImVec2 room = free_room(state);
    const bool split = state.probe->options.split;  // then the corner is taken
    const float y = split ? window_margin() : room.y - window_margin();
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
        ImGui::SetNextWindowPos(ImVec2(middle, room.y - window_margin() - hash_corner_height(state)), ImGuiCond_Always,
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
