// The strip: the dispatches of the step in the order in which they run, the one that ran last lit, and what it did.
#include <algorithm>
#include <array>
#include <string>

#include "ui/panels.h"
#include "ui/stage_sentence.h"
#include "ui/stepping_panels.h"
#include "ui/strip_layout.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

const vec3 idle_mark(0.26f, 0.30f, 0.35f);
const vec3 chip_colour(0.13f, 0.155f, 0.185f);

// What every row of the strip draws from.
struct Strip {
    const State& state;
    const SteppingState& stepping;
    Commands& commands;
    std::vector<StripChip> chips;
    float width = 0.0f;

    std::uint32_t dispatches() const { return static_cast<std::uint32_t>(stepping.schedule->dispatches.size()); }
    vec3 colour(Stage stage) const { return stepping.stage_colours[static_cast<std::size_t>(stage)]; }
    void go_to(std::uint32_t substep, std::uint32_t ran) const {
        commands.push_back(GoTo{{{stepping.place.substep.step, substep}, ran}});
    }
};

ImDrawList& canvas() { return *ImGui::GetWindowDrawList(); }

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

void header_row(const Strip& strip) {
    ImGui::AlignTextToFramePadding();
    text(place_text(strip.stepping));
    unit_buttons(strip);
    motion_buttons(strip);
}

// One block a substep of this step: how much of each has run; the one that is spread out below has the frame.
void overview_row(const Strip& strip) {
    const float height = 0.75f * em();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const Place& place = strip.stepping.place;
    const auto blocks = substep_blocks(std::max(strip.stepping.substeps, place.substep.substep + 1),
                                       place.substep.substep, strip.width, 0.8f * em());
    for (const StripBlock& block : blocks) {
        const bool shown = block.substep == place.substep.substep;
        const float gap = std::min(0.12f * em(), 0.1f * (block.right - block.left));
        const ImVec2 a(low.x + block.left + gap, low.y);
        const ImVec2 b(low.x + block.right - gap, low.y + height);
        const float done = block.substep < place.substep.substep ? 1.0f
                           : shown && strip.dispatches() > 0
                               ? static_cast<float>(place.ran) / static_cast<float>(strip.dispatches())
                               : 0.0f;
        canvas().AddRectFilled(a, b, packed(idle_mark), 2.0f);
        canvas().AddRectFilled(a, ImVec2(a.x + done * (b.x - a.x), b.y), packed(vec3(0.45f, 0.55f, 0.64f)), 2.0f);
        if (shown) {
            canvas().AddRect(a, b, packed(text_colour), 2.0f, 0, 2.0f);
            const float end = low.y + height + ImGui::GetStyle().ItemSpacing.y + 0.15f * em();
            canvas().AddQuadFilled(ImVec2(a.x, b.y), ImVec2(b.x, b.y), ImVec2(low.x + strip.width, end),
                                   ImVec2(low.x, end), packed(vec3(0.45f, 0.55f, 0.64f), 0.30f));
        }
    }
    if (ImGui::InvisibleButton("substeps", ImVec2(strip.width, height))) {
        const float x = ImGui::GetIO().MousePos.x - low.x;
        const auto hit = std::ranges::find_if(blocks, [&](const StripBlock& b) { return x < b.right; });
        if (hit != blocks.end()) {
            strip.go_to(hit->substep, strip.dispatches());
        }
    }
    tooltip("The substeps of this step. A click goes to the end of one.");
}

void centred(const std::string& words, float left, float right, float y, ImU32 colour) {
    const float width = ImGui::CalcTextSize(words.c_str()).x;
    canvas().PushClipRect(ImVec2(left, y - em()), ImVec2(right, y + 2.0f * em()), true);
    canvas().AddText(ImVec2(std::max(left, 0.5f * (left + right - width)), y), colour, words.c_str());
    canvas().PopClipRect();
}

bool is_current(const Strip& strip, const StripChip& chip) {
    const std::uint32_t ran = strip.stepping.place.ran;
    return ran > chip.first && ran <= chip.last;
}

void chip_names(const Strip& strip) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float height = 1.35f * em();
    for (const StripChip& chip : strip.chips) {
        ImGui::PushID(static_cast<int>(chip.first));
        const ImVec2 a(low.x + chip.left, low.y);
        const ImVec2 b(low.x + chip.right, low.y + height);
        const bool current = is_current(strip, chip);
        canvas().AddRectFilled(a, b, current ? packed(accent_colour) : packed(chip_colour), 4.0f,
                               ImDrawFlags_RoundCornersTop);
        canvas().AddRectFilled(a, ImVec2(a.x + 0.3f * em(), b.y), packed(strip.colour(chip.stage)), 4.0f,
                               ImDrawFlags_RoundCornersTopLeft);
        const bool started = strip.stepping.place.ran > chip.first;
        centred(std::string(stage_name(chip.stage)), a.x, b.x, a.y + 0.15f * em(),
                packed(started ? text_colour : dim_colour));
        if (chip.last < strip.dispatches()) {
            canvas().AddText(ImVec2(b.x + 0.12f * em(), a.y + 0.15f * em()), packed(dim_colour), "›");
        }
        ImGui::SetCursorScreenPos(a);
        if (ImGui::InvisibleButton("name", ImVec2(b.x - a.x, height))) {
            strip.go_to(strip.stepping.place.substep.substep, chip.last);
        }
        tooltip("Goes to the end of this stage. Promised then: " + std::string(stage_promise(chip.stage)) + ".");
        ImGui::PopID();
    }
    ImGui::SetCursorScreenPos(ImVec2(low.x, low.y + height));
}

void one_mark(const Strip& strip, const StripChip& chip, std::uint32_t dispatch, const ImVec2& low, float height) {
    const StripMark mark = mark_of(chip, dispatch);
    const float wide = mark.right - mark.left;
    const float gap = wide > 4.0f ? std::min(0.15f * wide, 2.0f) : 0.0f;
    const std::uint32_t ran = strip.stepping.place.ran;
    const bool current = dispatch + 1 == ran;
    const bool done = dispatch < ran;
    const ImVec2 a(low.x + mark.left + gap, low.y + (current ? 0.0f : 0.2f * height));
    const ImVec2 b(low.x + std::max(mark.right - gap, mark.left + gap + (current ? 3.0f : 1.0f)), low.y + height);
    canvas().AddRectFilled(a, b, current ? packed(text_colour) : packed(done ? strip.colour(chip.stage) : idle_mark));
}

void chip_marks(const Strip& strip) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float height = 1.2f * em();
    const float x = ImGui::GetIO().MousePos.x - low.x;
    for (const StripChip& chip : strip.chips) {
        canvas().AddRectFilled(ImVec2(low.x + chip.left, low.y), ImVec2(low.x + chip.right, low.y + height),
                               packed(chip_colour));
        for (std::uint32_t dispatch = chip.first; dispatch < chip.last; ++dispatch) {
            one_mark(strip, chip, dispatch, low, height);
        }
    }
    const bool clicked = ImGui::InvisibleButton("marks", ImVec2(strip.width, height));
    if (!ImGui::IsItemHovered()) {
        return;
    }
    for (const StripChip& chip : strip.chips) {
        if (const auto dispatch = dispatch_at(chip, x)) {
            tooltip(strip.stepping.schedule->dispatches[*dispatch].name +
                    format("\ndispatch %u of %u: click to go there", *dispatch + 1, strip.dispatches()));
            if (clicked) {
                strip.go_to(strip.stepping.place.substep.substep, *dispatch + 1);
            }
        }
    }
}

void badges_row(const Strip& strip) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float height = 1.3f * em();
    for (const StripChip& chip : strip.chips) {
        const Badge badge = stage_badge(strip.stepping.check, chip.stage);
        const ImVec2 a(low.x + chip.left, low.y);
        const ImVec2 b(low.x + chip.right, low.y + height);
        canvas().AddRectFilled(a, b, packed(chip_colour), 4.0f, ImDrawFlags_RoundCornersBottom);
        centred(badge_text(badge), a.x, b.x, a.y + 0.1f * em(), packed(badge_colour(badge.kind)));
        ImGui::PushID(static_cast<int>(chip.first));
        ImGui::SetCursorScreenPos(a);
        if (ImGui::InvisibleButton("badge", ImVec2(b.x - a.x, height))) {
            strip.commands.push_back(ShowDifferences{chip.stage});
        }
        if (!badge.detail.empty()) {
            tooltip(badge.detail);
        }
        ImGui::PopID();
    }
    ImGui::SetCursorScreenPos(ImVec2(low.x, low.y + height + ImGui::GetStyle().ItemSpacing.y));
}

void scrub_row(const Strip& strip) {
    const SteppingState& stepping = strip.stepping;
    const float half = 0.5f * (strip.width - ImGui::GetStyle().ItemSpacing.x);
    const auto per_substep = static_cast<int>(strip.dispatches());
    int place = static_cast<int>(stepping.place.substep.substep) * per_substep + static_cast<int>(stepping.place.ran);
    const int most = static_cast<int>(std::max(stepping.substeps, stepping.place.substep.substep + 1)) * per_substep;
    ImGui::SetNextItemWidth(half);
    const std::string within = format("%%d of %d dispatches of the step", most);
    if (per_substep > 0 && ImGui::SliderInt("##within", &place, 0, most, within.c_str())) {
        place = std::clamp(place, 0, most);
        const int substep = std::min(place / per_substep, most / per_substep - 1);
        strip.go_to(static_cast<std::uint32_t>(substep), static_cast<std::uint32_t>(place - substep * per_substep));
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

void large_line(const std::string& words, const ImVec4& colour) {
    const float size = 1.2f * em();
    ImFont* font = ImGui::GetFont();
    const ImVec2 place = ImGui::GetCursorScreenPos();
    const float room = ImGui::GetContentRegionAvail().x;
    const float wide = font->CalcTextSizeA(size, FLT_MAX, 0.0f, words.c_str()).x;
    const float fitting = wide > room ? size * room / wide : size;  // a long sentence is written smaller
    canvas().AddText(font, fitting, ImVec2(place.x, place.y + 0.5f * (size - fitting)), packed(colour), words.c_str());
    ImGui::Dummy(ImVec2(room, size));
}

void sentence_row(const Strip& strip) {
    const SteppingState& stepping = strip.stepping;
    if (stepping.divergence) {
        std::string words = "DIVERGED at step " + grouped(stepping.divergence->step);
        words += stepping.divergence->ball ? ", ball " + grouped(*stepping.divergence->ball) : "";
        large_line(words + ": a replay gave other bytes than the first run.", badge_colour(Badge::Kind::differs));
    }
    if (strip.state.running) {
        large_line("Running. Space pauses; → and ← step by the unit chosen above.", dim_colour);
        return;
    }
    const std::string words = stage_sentence(stepping.numbers);
    const bool nothing = stepping.place.ran == 0;
    large_line(nothing ? "Nothing of this substep has run yet." : words, nothing ? dim_colour : text_colour);
}

// The first red badge in words: what the lecturer would have to hover for.
void alarm_row(const Strip& strip) {
    for (const StripChip& chip : strip.chips) {
        const Badge badge = stage_badge(strip.stepping.check, chip.stage);
        if (badge.kind == Badge::Kind::differs) {
            ImGui::PushStyleColor(ImGuiCol_Text, badge_colour(badge.kind));
            wrapped_text(std::string(stage_name(chip.stage)) + ": " + badge.detail);
            ImGui::PopStyleColor();
            return;
        }
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

void footer_row(const Strip& strip) {
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

}  // namespace

ImVec4 badge_colour(Badge::Kind kind) {
    switch (kind) {
        case Badge::Kind::same:
            return {0.25f, 0.80f, 0.62f, 1.0f};
        case Badge::Kind::within:
            return {0.98f, 0.74f, 0.25f, 1.0f};
        case Badge::Kind::differs:
            return {1.0f, 0.47f, 0.36f, 1.0f};
        case Badge::Kind::none:
        case Badge::Kind::not_judged:
            break;
    }
    return dim_colour;
}

std::string badge_text(const Badge& badge) {
    switch (badge.kind) {
        case Badge::Kind::same:
            return "● " + badge.text;
        case Badge::Kind::within:
            return "▲ " + badge.text;
        case Badge::Kind::differs:
            return "■ " + badge.text;
        case Badge::Kind::not_judged:
            return "○ " + badge.text;
        case Badge::Kind::none:
            break;
    }
    return "–";
}

void stepper_strip(const State& state, Commands& commands) {
    Strip strip{state, *state.stepping, commands, {}, ImGui::GetContentRegionAvail().x};
    strip.chips = stage_chips(*strip.stepping.schedule, strip.width, 0.6f * em());
    header_row(strip);
    if (strip.stepping.substeps > 1) {
        overview_row(strip);
    }
    if (strip.chips.empty()) {
        dim_text("No balls: a substep has no dispatches.");
    } else {
        chip_names(strip);
        chip_marks(strip);
        if (strip.stepping.check.mode != LiveCheckMode::off) {
            badges_row(strip);
        }
    }
    sentence_row(strip);
    alarm_row(strip);
    scrub_row(strip);
    footer_row(strip);
}

}  // namespace ballpit::ui
