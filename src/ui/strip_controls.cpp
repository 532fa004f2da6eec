// The controls of the strip: unit, motion, sliders, check and memory.
#include <algorithm>
#include <array>
#include <string>

#include "ui/stage_sentence.h"
#include "ui/strip.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

void unit_buttons(const Strip& strip) {
    constexpr std::array<Action, 4> actions = {Action::unit_pass, Action::unit_stage, Action::unit_substep,
                                               Action::unit_step};
    for (std::size_t i = 0; i < actions.size(); ++i) {
        const auto unit = static_cast<StepUnit>(i);
        ImGui::SameLine(0.0f, i == 0 ? 1.2f * em() : 0.15f * em());
        const bool chosen = unit == strip.stepping.unit;
        if (chosen) {
            ImGui::PushStyleColor(ImGuiCol_Button, accent_colour);
        }
        if (ImGui::Button(std::string(step_unit_names[i]).c_str())) {
            strip.commands.push_back(ChooseUnit{unit});
        }
        if (chosen) {
            ImGui::PopStyleColor();
        }
        tooltip("The arrow keys move by this unit. Key: " + std::string(key_hint(actions[i])));
    }
}

void motion_buttons(const Strip& strip) {
    struct Button {
        const char* label;
        Action action;
        const char* about;
    };
    constexpr std::array<Button, 4> buttons = {{{"⇤", Action::step_start, "To the start of the step. Key: "},
                                                {"←", Action::back, "One unit back. Key: "},
                                                {"→", Action::forward, "One unit forth. Key: "},
                                                {"⇥", Action::step_end, "To the end of the step. Key: "}}};
    for (std::size_t i = 0; i < buttons.size(); ++i) {
        ImGui::SameLine(0.0f, i == 0 ? 1.2f * em() : 0.15f * em());
        if (ImGui::Button(buttons[i].label, ImVec2(2.0f * em(), 0.0f))) {
            strip.commands.push_back(buttons[i].action);
        }
        tooltip(buttons[i].about + std::string(key_hint(buttons[i].action)));
    }
}

void check_choice(const Strip& strip) {
    const LiveCheckState& check = strip.stepping.check;
    text("Check");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(11.5f * em());
    const auto chosen = static_cast<std::size_t>(check.mode);
    if (ImGui::BeginCombo("##check", live_check_names[chosen].data())) {
        if (strip.state.close_popups) {
            ImGui::CloseCurrentPopup();
        }
        for (std::size_t i = 0; i < live_check_names.size(); ++i) {
            if (ImGui::Selectable(live_check_names[i].data(), i == chosen)) {
                strip.commands.push_back(SetLiveCheck{static_cast<LiveCheckMode>(i)});
            }
        }
        ImGui::EndCombo();
    }
    tooltip(
        "Runs every dispatch on the mirror, too, on the same input, and compares; or checks only what each stage "
        "promises. Key: " +
        std::string(key_hint(Action::toggle_live_check)));
    ImGui::SameLine();
    if (check.mode == LiveCheckMode::off) {
        dim_text(key_hint(Action::toggle_live_check));
    } else if (check.mode == LiveCheckMode::mirror && check.mirror_computes) {
        dim_text("the mirror computes");
        tooltip("The mirror is what computes: there is nothing to compare it with. The invariants are checked.");
    } else {
        dim_text(format("%.1f ms", check.ms));
        tooltip("What the check of a substep takes, the substep itself included.");
    }
}

std::string mebibytes(std::size_t bytes) {
    const double amount = static_cast<double>(bytes) / (1 << 20);
    return amount < 10.0 ? format("%.1f", amount) : format("%.0f", amount);
}

void budget_choice(const Strip& strip) {
    const SteppingState& stepping = strip.stepping;
    const std::string used = format("%zu %s, %s of", stepping.checkpoint_count,
                                    stepping.checkpoint_count == 1 ? "checkpoint" : "checkpoints",
                                    mebibytes(stepping.checkpoint_bytes).c_str());
    const float combo = 6.4f * em();
    const float wide = ImGui::CalcTextSize(used.c_str()).x + ImGui::GetStyle().ItemSpacing.x + combo;
    ImGui::SameLine(std::max(ImGui::GetStyle().WindowPadding.x + strip.width - wide, 0.0f));
    dim_text(used);
    tooltip(
        "Copies of the state on the device: going back starts from the nearest one. Beyond the budget the far past "
        "is thinned out.");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(combo);
    if (!ImGui::BeginCombo("##budget", (mebibytes(stepping.checkpoint_budget) + " MiB").c_str())) {
        return;
    }
    if (strip.state.close_popups) {
        ImGui::CloseCurrentPopup();
    }
    for (std::size_t mib = 16; mib <= 4096; mib *= 4) {
        const std::size_t bytes = mib << 20;
        if (ImGui::Selectable((std::to_string(mib) + " MiB").c_str(), bytes == stepping.checkpoint_budget)) {
            strip.commands.push_back(SetCheckpointBudget{bytes});
        }
    }
    ImGui::EndCombo();
}

// Of a step, before this substep begins: not every one builds a grid.
std::uint32_t dispatches_before(const SteppingState& stepping, std::uint32_t substep) {
    const std::uint32_t builds = (substep + stepping.grid_reuse - 1) / stepping.grid_reuse;
    return builds * stepping.building + (substep - builds) * stepping.using_again;
}

}  // namespace

void strip_header(const Strip& strip) {
    ImGui::AlignTextToFramePadding();
    text(place_text(strip.stepping));
    unit_buttons(strip);
    motion_buttons(strip);
}

void strip_sliders(const Strip& strip) {
    const SteppingState& stepping = strip.stepping;
    const float half = 0.5f * (strip.width - ImGui::GetStyle().ItemSpacing.x);
    const std::uint32_t shown = stepping.place.substep.substep;
    auto place = static_cast<int>(dispatches_before(stepping, shown) + stepping.place.ran);
    const auto most = static_cast<int>(dispatches_before(stepping, std::max(stepping.substeps, shown + 1)));
    ImGui::SetNextItemWidth(half);
    const std::string within = format("%%d of %d dispatches of the step", most);
    if (most > 0 && ImGui::SliderInt("##within", &place, 0, most, within.c_str())) {
        const auto wanted = static_cast<std::uint32_t>(std::clamp(place, 0, most));
        std::uint32_t substep = 0;
        while (dispatches_before(stepping, substep + 1) <= wanted && substep + 1 < stepping.substeps) {
            ++substep;
        }
        strip.go_to(substep, wanted - dispatches_before(stepping, substep));
    }
    ImGui::SameLine();
    ImGui::SetNextItemWidth(half);
    std::uint64_t step = stepping.hash_step;
    const std::uint64_t furthest = std::max(stepping.furthest_step, stepping.hash_step);
    const std::string history = "%llu of " + std::to_string(furthest) + " steps done";
    if (ImGui::SliderScalar("##history", ImGuiDataType_U64, &step, &stepping.first_step, &furthest, history.c_str())) {
        strip.commands.push_back(GoTo{{{std::clamp(step, stepping.first_step, furthest), 0}, 0}});
    }
}

void strip_footer(const Strip& strip) {
    ImGui::AlignTextToFramePadding();
    const SteppingState& stepping = strip.stepping;
    dim_text("State");
    ImGui::SameLine();
    text(stepping.hash ? format("%016llx", static_cast<unsigned long long>(*stepping.hash)) : "on its way …");
    tooltip(format("Hash of all positions and velocities after %s steps: the same number, the same state, bit for bit.",
                   grouped(stepping.hash_step).c_str()));
    ImGui::SameLine(0.0f, 1.5f * em());
    check_choice(strip);
    budget_choice(strip);
}

}  // namespace ballpit::ui
