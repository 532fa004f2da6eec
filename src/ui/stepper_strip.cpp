// The strip: the dispatches of the step in the order in which they run, the one that ran last lit, and what it did.
#include <algorithm>
#include <string>

#include "ui/stage_sentence.h"
#include "ui/strip.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

const vec3 idle_mark(0.26f, 0.30f, 0.35f);
const vec3 chip_colour(0.13f, 0.155f, 0.185f);

ImDrawList& canvas() { return *ImGui::GetWindowDrawList(); }

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
    strip_header(strip);
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
    strip_sliders(strip);
    strip_footer(strip);
}

}  // namespace ballpit::ui
