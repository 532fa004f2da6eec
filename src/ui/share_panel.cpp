// F: the code of this moment, and a scene file of it. At the bottom left the state hash, for a class to compare.
#include <algorithm>
#include <cstring>
#include <vector>

#include "ui/panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

constexpr std::size_t longest_name = 200;

void code_row(const ShareState& share, Commands& commands) {
    ImGui::SetNextItemWidth(-FLT_MIN);
    // ImGui asks for text that it might change; read-only, it does not.
    std::vector<char> code(share.code.begin(), share.code.end());
    code.push_back('\0');
    ImGui::InputText("##code", code.data(), code.size(),
                     ImGuiInputTextFlags_ReadOnly | ImGuiInputTextFlags_AutoSelectAll);
    const float half = column_width(2);
    if (ImGui::Button("Copy", ImVec2(half, 0.0f))) {
        commands.push_back(CopyCode{});
    }
    ImGui::SameLine();
    if (key_button("Open what was copied", key_hint(Action::paste_code), half)) {
        commands.push_back(Action::paste_code);
    }
}

void file_row(const ShareState& share, Commands& commands) {
    const float button = 9.0f * em();
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button - ImGui::GetStyle().ItemSpacing.x);
    std::vector<char> name(longest_name + 1, '\0');
    std::memcpy(name.data(), share.file.data(), std::min(share.file.size(), longest_name));
    const bool entered = ImGui::InputText("##file", name.data(), name.size(), ImGuiInputTextFlags_EnterReturnsTrue);
    if (share.file != name.data()) {
        commands.push_back(NameFile{name.data()});
    }
    ImGui::SameLine();
    if (key_button("Save", key_hint(Action::save_scene), button) || entered) {
        commands.push_back(Action::save_scene);
    }
}

}  // namespace

void share_panel(const State& state, Commands& commands) {
    const ShareState& share = *state.share;
    wrapped_text("This moment as one line: the scene, what was done to it, the step, and how it is looked at.");
    code_row(share, commands);
    if (!share.note.empty()) {
        wrapped_dim_text(share.note);
    }
    ImGui::Spacing();
    ImGui::Separator();
    ImGui::Spacing();
    wrapped_text("Or as a scene file, which goes on from here:");
    file_row(share, commands);
    ImGui::Spacing();
    if (key_button("Close##share", key_hint(Action::share), 7.0f * em(), true)) {
        commands.push_back(Action::share);
    }
}

void replay_panel(const State& state) {
    const ReplayProgress& replay = *state.share->replay;
    text("Replaying step " + grouped(replay.step) + " of " + grouped(replay.of));
    const float share = replay.of > 0 ? static_cast<float>(replay.step) / static_cast<float>(replay.of) : 1.0f;
    ImGui::ProgressBar(share, ImVec2(18.0f * em(), 0.0f), "");
    dim_text("Esc stops here");
}

void hash_corner(const State& state) {
    const ShareState& share = *state.share;
    const std::string hash =
        share.hash ? format("%016llx", static_cast<unsigned long long>(*share.hash)) : std::string("…");
    dim_text("step " + grouped(share.hash_step) + "  " + hash);
    tooltip("A number for the state of all balls at the start of this step: equal numbers, equal bits.");
    if (share.match != HashMatch::unknown) {
        text(share.match_about);
    }
}

float hash_corner_height(const State& state) {
    if (state.share == nullptr) {
        return 0.0f;
    }
    const float lines = state.share->match == HashMatch::unknown ? 1.0f : 2.0f;
    return lines * ImGui::GetTextLineHeightWithSpacing() + 0.9f * em();
}

}  // namespace ballpit::ui
