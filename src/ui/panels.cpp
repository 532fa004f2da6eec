// The layout: numbers and sentences stacked at the top left, cells at the bottom left, controls at the right.
#include "ui/panels.h"

#include <algorithm>

#include "ui/budget_panel.h"
#include "ui/costs_panel.h"
#include "ui/explorer_panel.h"
#include "ui/laws_panel.h"
#include "ui/meters_panel.h"
#include "ui/probe_panels.h"
#include "ui/stepping_panels.h"
#include "ui/style.h"

namespace ballpit::ui {

namespace {

constexpr ImGuiWindowFlags fixed_window = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                          ImGuiWindowFlags_NoResize | ImGuiWindowFlags_AlwaysAutoResize |
                                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                          ImGuiWindowFlags_NoNav;

constexpr float panel_width = 21.0f;  // em

float margin() { return 0.6f * em(); }

// Windows below one another at the left edge.
class Stack {
public:
    template <class Content>
    void window(const char* name, const Content& content) {
        ImGui::SetNextWindowPos(ImVec2(margin(), y_));
        ImGui::Begin(name, nullptr, fixed_window);
        content();
        y_ += ImGui::GetWindowHeight() + margin();
        ImGui::End();
    }
    template <class Content>
    void window(const char* name, const ImVec4& background, const Content& content) {
        ImGui::PushStyleColor(ImGuiCol_WindowBg, background);
        window(name, content);
        ImGui::PopStyleColor();
    }

private:
    float y_ = margin();
};

void left_side(const State& state, Commands& commands) {
    Stack stack;
    if (state.view.panels) {
        stack.window("frame rate", [&] { frame_rate_panel(state); });
    }
    // What went wrong stays on screen even when the panels are hidden.
    if (!state.message.empty()) {
        stack.window("message", notice_colour, [&] { message_panel(state, commands); });
    }
    if (has_failure(state)) {
        stack.window("status", alarm_colour, [&] { status_panel(state, commands); });
    }
    if (state.view.panels && has_warning(state)) {
        stack.window("warnings", notice_colour, [&] { warnings_panel(state, commands); });
    }
    if (state.view.panels && state.view.timings) {
        stack.window("timings", [&] { timings_panel(state); });
    }
    if (state.view.panels && state.view.occupancy) {
        const float bottom = ImGui::GetIO().DisplaySize.y - margin() - strip_height(state) - hash_corner_height(state);
        ImGui::SetNextWindowPos(ImVec2(margin(), bottom), ImGuiCond_Always, ImVec2(0.0f, 1.0f));
        ImGui::Begin("occupancy", nullptr, fixed_window);
        occupancy_panel(state);
        ImGui::End();
    }
}

void right_side(const State& state, Commands& commands) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float width = std::min(panel_width * em(), display.x - 2.0f * margin());
    const float most = std::max(display.y - 2.0f * margin(), 4.0f * em());
    // A scroll bar stands in the margin, so that it takes nothing from the rows.
    ImGuiStorage* memory = ImGui::GetStateStorage();
    const ImGuiID scrolls = ImGui::GetID("controls scroll");
    const float bar = memory->GetBool(scrolls) ? std::min(ImGui::GetStyle().ScrollbarSize, margin()) : 0.0f;
    ImGui::SetNextWindowPos(ImVec2(display.x - margin() + bar, margin()), ImGuiCond_Always, ImVec2(1.0f, 0.0f));
    ImGui::SetNextWindowSizeConstraints(ImVec2(width + bar, 0.0f), ImVec2(width + bar, most));
    ImGui::Begin("controls", nullptr, fixed_window);
    scene_panel(state, commands);
    run_panel(state, commands);
    settings_panel(state, commands);
    view_panel(state, commands);
    light_panel(state, commands);
    if (state.probe != nullptr) {
        probe_section(state, commands);
    }
    laws_section(state, commands);
    meters_section(commands);
    budget_section(state, commands);
    if (state.play != nullptr) {
        play_section(state, commands);
    }
    memory->SetBool(scrolls, ImGui::GetScrollMaxY() > 0.0f);
    ImGui::End();
}

// Small, without a frame: it is there all the time, whatever else is hidden.
void corner_window(const State& state) {
    ImGui::SetNextWindowPos(ImVec2(margin(), ImGui::GetIO().DisplaySize.y - 0.4f * em() - strip_height(state)),
                            ImGuiCond_Always, ImVec2(0.0f, 1.0f));
    ImGui::SetNextWindowBgAlpha(0.6f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.4f * em(), 0.1f * em()));
    ImGui::Begin("state hash", nullptr, fixed_window | ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleVar(2);
    hash_corner(state);
    ImGui::End();
}

// Both stand in the middle of what the side panel leaves free.
template <class Content>
void middle_window(const State& state, const char* name, const Content& content) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float free = display.x - (state.view.panels ? side_panel_width() : 0.0f);
    ImGui::SetNextWindowPos(ImVec2(0.5f * free, 0.4f * display.y), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowSizeConstraints(ImVec2(std::min(30.0f * em(), display.x), 0.0f),
                                        ImVec2(std::min(30.0f * em(), display.x), display.y));
    ImGui::SetNextWindowBgAlpha(0.97f);
    ImGui::Begin(name, nullptr, fixed_window);
    content();
    ImGui::End();
}

void share_windows(const State& state, Commands& commands) {
    corner_window(state);
    if (state.share->replay) {
        middle_window(state, "replay", [&] { replay_panel(state); });
    } else if (state.share->open) {
        middle_window(state, "share", [&] { share_panel(state, commands); });
    }
}

void help_window(const State& state, Commands& commands) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(0.5f * display.x, 0.5f * display.y), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowSizeConstraints(ImVec2(0.0f, 0.0f),
                                        ImVec2(display.x - 2.0f * margin(), display.y - 2.0f * margin()));
    ImGui::SetNextWindowBgAlpha(0.97f);
    ImGui::SetNextWindowFocus();
    ImGui::Begin("help", nullptr, fixed_window);
    help_page(state, commands);
    ImGui::End();
}

}  // namespace

float side_panel_width() { return panel_width * em() + 2.0f * margin(); }

void draw_panels(const State& state, Commands& commands) {
    left_side(state, commands);
    if (state.view.panels) {
        right_side(state, commands);
    }
    if (state.probe != nullptr) {
        draw_probe_windows(state, commands);
    }
    draw_laws_window(state, commands);
    draw_meters_window(state, commands);
    draw_budget_window(state, commands);
    draw_explorer_window(state, commands);
    draw_costs_window(state, commands);
    draw_stepping_windows(state, commands);  // opened on purpose: they stay when the panels are hidden
    if (state.share != nullptr) {
        share_windows(state, commands);
    }
    if (state.view.help) {
        help_window(state, commands);
    }
}

}  // namespace ballpit::ui
