// Run, pause, one step, restart; how fast time goes.
#include "ui/panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

void action_button(const char* label, Action action, float width, Commands& commands, bool accent = false) {
    if (key_button(label, key_hint(action), width, accent)) {
        commands.push_back(action);
    }
}

void speed_row(const State& state, Commands& commands) {
    const float button = ImGui::GetFrameHeight();
    const float end = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
    row_label("Time speed",
              "Simulated seconds a second. The step length stays as it is: only the number of steps "
              "changes, and a slow machine shows slow motion.",
              button + ImGui::GetStyle().ItemInnerSpacing.x);
    double speed = state.speed;
    if (ImGui::SliderScalar("##speed", ImGuiDataType_Double, &speed, &slowest_time, &fastest_time, "%.3g ×",
                            ImGuiSliderFlags_Logarithmic)) {
        commands.push_back(ChangeSpeed{speed});
    }
    if (state.speed != 1.0) {
        ImGui::SameLine(end - button);
        if (ImGui::Button("↺##speed", ImVec2(button, 0.0f))) {
            commands.push_back(ChangeSpeed{1.0});
        }
        tooltip("Back to real time");
    }
}

}  // namespace

void run_panel(const State& state, Commands& commands) {
    ImGui::Spacing();
    const float half = column_width(2);
    action_button(state.running ? "Pause" : "Run", Action::toggle_run, half, commands, true);
    ImGui::SameLine();
    action_button("One step", Action::one_step, half, commands);
    action_button("Restart", Action::restart, half, commands);
    ImGui::SameLine();
    action_button("New seed", Action::new_seed, half, commands);
    speed_row(state, commands);
}

}  // namespace ballpit::ui
