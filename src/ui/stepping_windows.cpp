// Where the strip, the microscope and the table of differences stand.
#include <algorithm>

#include "ui/panels.h"
#include "ui/stepping_panels.h"
#include "ui/style.h"

namespace ballpit::ui {

namespace {

constexpr ImGuiWindowFlags titled = ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                    ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoResize | ImGuiWindowFlags_AlwaysAutoResize;
constexpr ImGuiWindowFlags fixed = titled | ImGuiWindowFlags_NoTitleBar;

constexpr float microscope_height = 19.5f;  // em

float margin() { return 0.6f * em(); }

bool has_alarm(const LiveCheckState& check) {
    for (std::size_t i = 0; i < stage_count; ++i) {
        if (stage_badge(check, static_cast<Stage>(i)).kind == Badge::Kind::differs) {
            return true;
        }
    }
    return false;
}

// Beside the side panel, or across the window where that is hidden.
float free_width(const State& state) {
    const float display = ImGui::GetIO().DisplaySize.x;
    const float panel = state.view.panels ? side_panel_width() - margin() : margin();
    return std::max(display - panel - margin(), 24.0f * em());
}

void strip_window(const State& state, Commands& commands) {
    const float width = free_width(state) - margin();
    ImGui::SetNextWindowPos(ImVec2(margin(), ImGui::GetIO().DisplaySize.y - margin()), ImGuiCond_Always,
                            ImVec2(0.0f, 1.0f));
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0.0f), ImVec2(width, FLT_MAX));
    ImGui::Begin("stepper", nullptr, fixed);
    stepper_strip(state, commands);
    ImGui::End();
}

// A window with a title and a cross, as high as its content; false: the cross was pressed. `above`: pixels kept free
// below it.
template <class Content>
bool tool_window(const State& state, const char* title, float above, const Content& content) {
    const float width = free_width(state) - margin();
    const float bottom = ImGui::GetIO().DisplaySize.y - above - margin();
    ImGui::SetNextWindowPos(ImVec2(margin(), bottom), ImGuiCond_Always, ImVec2(0.0f, 1.0f));
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0.0f), ImVec2(width, FLT_MAX));
    ImGui::SetNextWindowBgAlpha(0.97f);  // numbers and thin lines stand in it
    bool open = true;
    if (ImGui::Begin(title, &open, titled)) {
        content();
    }
    ImGui::End();
    return open;
}

}  // namespace

float strip_height(const State& state) {
    if (!state.view.stepper || state.stepping == nullptr) {
        return 0.0f;
    }
    const SteppingState& stepping = *state.stepping;
    const ImGuiStyle& style = ImGui::GetStyle();
    const float spacing = style.ItemSpacing.y;
    float height = 3.0f * (ImGui::GetFrameHeight() + spacing) + 2.0f * style.WindowPadding.y;
    height += 1.35f * em() + 1.2f * em() + 1.2f * em() + 3.0f * spacing;
    height += stepping.substeps > 1 ? 0.75f * em() + spacing : 0.0f;
    height += stepping.check.mode != LiveCheckMode::off ? 1.3f * em() + spacing : 0.0f;
    height += stepping.divergence ? 1.2f * em() + spacing : 0.0f;
    height += has_alarm(stepping.check) ? 2.0f * ImGui::GetTextLineHeightWithSpacing() : 0.0f;
    return height + margin();
}

float covered_height(const State& state) {
    const float strip = strip_height(state);
    if (state.stepping != nullptr && state.stepping->check.shown) {
        return strip + differences_height(state);
    }
    return strip + (state.view.microscope && state.stepping != nullptr ? microscope_height * em() + margin() : 0.0f);
}

void draw_stepping_windows(const State& state, Commands& commands) {
    if (state.stepping == nullptr) {
        return;
    }
    if (state.view.stepper) {
        strip_window(state, commands);
    }
    const float strip = strip_height(state);
    const bool differences = state.stepping->check.shown.has_value();  // one of the two: there is no room for both
    if (state.view.microscope && !differences &&
        !tool_window(state, "Bitonic sort", strip, [&] { microscope_panel(state, commands); })) {
        commands.push_back(Action::toggle_microscope);
    }
    if (differences && !tool_window(state, "Differences", strip, [&] { differences_panel(state, commands); })) {
        commands.push_back(ShowDifferences{});
    }
}

}  // namespace ballpit::ui
