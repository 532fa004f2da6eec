// Which scene runs: its name, what it shows, and the others to choose from.
#include "ui/panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

void scene_list(const State& state, Commands& commands) {
    if (state.close_popups) {
        ImGui::CloseCurrentPopup();
    }
    for (std::size_t i = 0; i < state.scenes.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::Selectable(state.scenes[i].name.c_str(), i == state.scene)) {
            commands.push_back(ChooseScene{i});
        }
        tooltip(state.scenes[i].about);
        ImGui::PopID();
    }
}

}  // namespace

void scene_panel(const State& state, Commands& commands) {
    const SceneChoice& current = state.scenes[state.scene];
    const float button = ImGui::GetFrameHeight();
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 2.0f * (button + gap));
    if (ImGui::BeginCombo("##scene", current.name.c_str(), ImGuiComboFlags_HeightLarge)) {
        scene_list(state, commands);
        ImGui::EndCombo();
    }
    for (const Action action : {Action::previous_scene, Action::next_scene}) {
        ImGui::SameLine(0.0f, gap);
        if (ImGui::Button(key_hint(action).data(), ImVec2(button, 0.0f))) {
            commands.push_back(action);
        }
        tooltip(action == Action::previous_scene ? "Previous scene" : "Next scene");
    }
    wrapped_dim_text(current.about);
}

}  // namespace ballpit::ui
