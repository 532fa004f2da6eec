// The keys of the sort under a microscope: cells with their values, arcs for what the last pass compared and swapped,
// and the whole network with a cursor.
#include <algorithm>
#include <array>
#include <cmath>

#include "measure/sort_pass.h"
#include "ui/microscope_scope.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

const vec3 selected_colour(1.0f, 0.85f, 0.2f);

ImDrawList& canvas() { return *ImGui::GetWindowDrawList(); }

vec3 tint(const Scope& scope, const Key& key) { return scope.state.which_colour(key.ball_id); }

void arrow_head(const ImVec2& tip, ImU32 colour, float size) {
    canvas().AddTriangleFilled(tip, ImVec2(tip.x - 0.55f * size, tip.y - size),
                               ImVec2(tip.x + 0.55f * size, tip.y - size), colour);
}

// From slot to slot; the head shows where the larger key belongs.
void arc(const measure::CompareExchange& pair, float left, float right, float floor, float height) {
    const float alpha = pair.swapped ? 1.0f : 0.42f;
    const ImU32 colour = packed(Scope::direction_colour(pair.ascending), alpha);
    const float head = (pair.swapped ? 0.5f : 0.36f) * em();
    const float to = pair.ascending ? right : left;
    const float from = pair.ascending ? left : right;
    const float top = floor - 1.33f * height;
    canvas().AddBezierCubic(ImVec2(from, floor), ImVec2(from, top), ImVec2(to, top), ImVec2(to, floor - 0.8f * head),
                            colour, pair.swapped ? 3.5f : 1.2f);
    arrow_head(ImVec2(to, floor), colour, head);
}

void centred(const std::string& words, float x, float y, ImU32 colour) {
    canvas().AddText(ImVec2(std::round(x - 0.5f * ImGui::CalcTextSize(words.c_str()).x), y), colour, words.c_str());
}

// Where the slots of a window lie.
struct Row {
    SlotWindow window;
    float left = 0.0f;
    float cell = 0.0f;  // width
    float gap = 0.0f;   // at the split

    float low(std::size_t i) const {
        return left + cell * static_cast<float>(i) + (window.split > 0 && i >= window.split ? gap : 0.0f);
    }
    float centre(std::size_t i) const { return low(i) + 0.5f * cell; }
    std::optional<std::size_t> at(float x) const {
        for (std::size_t i = 0; i < window.slots.size(); ++i) {
            if (x >= low(i) && x < low(i) + cell) {
                return i;
            }
        }
        return std::nullopt;
    }
};

Row make_row(const Scope& scope, float left) {
    const MicroscopeOptions& options = scope.state.view.microscope_options;
    Row row;
    row.window = slot_window(static_cast<std::uint32_t>(scope.keys.size()), options.slots, options.first,
                             scope.pass ? scope.pass->j : 0);
    row.left = left;
    row.gap = 1.6f * em();
    const float room = scope.width - (row.window.split > 0 ? row.gap : 0.0f);
    row.cell = room / static_cast<float>(row.window.slots.size());
    return row;
}

void draw_arcs(const Scope& scope, const Row& row, float floor, float height) {
    for (std::size_t i = 0; i < row.window.slots.size(); ++i) {
        const std::uint32_t slot = row.window.slots[i];
        const auto& slots = row.window.slots;
        const auto partner = std::ranges::find(slots, slot ^ scope.pass->j);
        if (partner == slots.end() || (slot & scope.pass->j) != 0) {
            continue;
        }
        const auto pair = measure::compare_exchange_of(slot, scope.pass->k, scope.pass->j, scope.before);
        const float right = row.centre(static_cast<std::size_t>(partner - slots.begin()));
        const float span = (right - row.centre(i)) / scope.width;
        arc(pair, row.centre(i), right, floor, height * std::clamp(0.35f + 1.3f * span, 0.0f, 1.0f));
    }
}

void draw_cell(const Scope& scope, const Row& row, std::size_t i, float top, float height) {
    const Key& key = scope.keys[row.window.slots[i]];
    const float inset = row.cell > 20.0f ? 1.5f : 0.5f;
    const ImVec2 a(row.low(i) + inset, top);
    const ImVec2 b(row.low(i) + row.cell - inset, top + height);
    canvas().AddRectFilled(a, b, packed(cell_colour), 2.0f);
    if (key.cell_id == SENTINEL) {
        hatch(a, b);
        return;
    }
    const std::string cell = grouped(key.cell_id);
    const std::string ball = ":" + std::to_string(key.ball_id);
    const bool fits =
        ImGui::CalcTextSize(cell.c_str()).x <= row.cell - 2.0f && ImGui::CalcTextSize(ball.c_str()).x <= row.cell;
    if (fits) {
        canvas().AddRectFilled(a, ImVec2(b.x, a.y + 0.35f * em()), packed(tint(scope, key)), 2.0f);
        centred(cell, row.centre(i), a.y + 0.4f * em(), packed(text_colour));
        centred(ball, row.centre(i), a.y + 1.4f * em(), packed(dim_colour));
    } else {  // the value as a height
        const float share =
            static_cast<float>(key.cell_id + 1) / static_cast<float>(std::max(scope.stepping.schedule->cell_count, 1u));
        canvas().AddRectFilled(ImVec2(a.x, b.y - std::clamp(share, 0.04f, 1.0f) * height), b, packed(tint(scope, key)));
    }
    if (scope.state.inspection != nullptr && scope.state.inspection->ball == key.ball_id) {
        canvas().AddRect(a, b, packed(selected_colour), 2.0f, 0, 2.5f);
    }
}

void slot_numbers(const Row& row, float y) {
    const std::size_t every = row.cell > 2.6f * em() ? 1 : 8;
    for (std::size_t i = 0; i < row.window.slots.size(); i += every) {
        centred(std::to_string(row.window.slots[i]), row.centre(i), y, packed(dim_colour));
    }
}

void cells_view(const Scope& scope) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const Row row = make_row(scope, low.x);
    const float arcs = 4.6f * em();
    const float cells = 2.55f * em();
    const float numbers = 1.15f * em();
    if (scope.compared()) {
        draw_arcs(scope, row, low.y + arcs, arcs - 0.4f * em());
    } else {
        centred(scope.pass ? "" : "No sort pass ran last: step to one, and its compare-exchanges show here.",
                low.x + 0.5f * scope.width, low.y + 0.4f * arcs, packed(dim_colour));
    }
    for (std::size_t i = 0; i < row.window.slots.size(); ++i) {
        draw_cell(scope, row, i, low.y + arcs, cells);
    }
    slot_numbers(row, low.y + arcs + cells);
    if (row.window.split > 0) {
        centred("…", low.x + 0.5f * scope.width, low.y + arcs + 0.6f * em(), packed(text_colour));
    }
    ImGui::InvisibleButton("cells", ImVec2(scope.width, arcs + cells + numbers));
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (const auto i = row.at(mouse.x); ImGui::IsItemHovered() && i && mouse.y >= low.y + arcs) {
        hovered_slot(scope, row.window.slots[*i]);
    }
}

std::span<const Key> keys_in(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const Key*>(bytes.data()), bytes.size() / sizeof(Key)};
}

void size_choice(const Scope& scope) {
    ViewOptions view = scope.state.view;
    MicroscopeOptions& options = view.microscope_options;
    constexpr std::array<std::pair<const char*, std::uint32_t>, 3> sizes = {{{"16", 16}, {"64", 64}, {"all", 0}}};
    bool changed = false;
    for (const auto& [label, slots] : sizes) {
        changed |= ImGui::RadioButton(label, options.slots == slots) && std::exchange(options.slots, slots) != slots;
        ImGui::SameLine();
    }
    text("slots");
    const auto count = static_cast<std::uint32_t>(scope.keys.size());
    if (options.slots != 0 && count > options.slots) {
        ImGui::SameLine();
        ImGui::SetNextItemWidth(14.0f * em());
        const std::uint32_t least = 0;
        const std::uint32_t most = count - options.slots;
        std::uint32_t first = std::min(options.first, most);
        if (ImGui::SliderScalar("##first", ImGuiDataType_U32, &first, &least, &most, "from slot %u")) {
            options.first = std::min(first, most) / options.slots * options.slots;
            changed = changed || options.first != scope.state.view.microscope_options.first;
        }
    }
    if (changed) {
        scope.commands.push_back(ChangeView{view});
    }
}

void legend(const Scope& scope) {
    if (!scope.compared()) {
        return;
    }
    const auto coloured = [](const char* words, const vec3& colour) {
        ImGui::SameLine();
        ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(colour.x, colour.y, colour.z, 1.0f));
        text(words);
        ImGui::PopStyleColor();
    };
    ImGui::SameLine(0.0f, 1.5f * em());
    dim_text("thick: swapped");
    coloured("→ ascending", ascending_colour);
    coloured("← descending", descending_colour);
}

}  // namespace

void hatch(const ImVec2& low, const ImVec2& high) {
    canvas().PushClipRect(low, high, true);
    const float step = 0.4f * em();
    for (float x = low.x - (high.y - low.y); x < high.x; x += step) {
        canvas().AddLine(ImVec2(x, high.y), ImVec2(x + (high.y - low.y), low.y),
                         packed(vec3(0.66f, 0.71f, 0.77f), 0.55f), 1.0f);
    }
    canvas().PopClipRect();
}

void hovered_slot(const Scope& scope, std::uint32_t slot) {
    tooltip(slot_story(slot, scope.pass, scope.keys, scope.before));
    const Key& key = scope.keys[slot];
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && key.cell_id != SENTINEL) {
        scope.commands.push_back(SelectBall{key.ball_id, true});
    }
}

void microscope_panel(const State& state, Commands& commands) {
    const SteppingState& stepping = *state.stepping;
    if (stepping.schedule->key_count == 0) {
        dim_text(stepping.schedule->ball_count == 0
                     ? "No balls, no keys."
                     : "Nothing is sorted here: this scene and these settings need no cells.");
        return;
    }
    Scope scope{state, stepping, commands, {}, {}, {}, ImGui::GetContentRegionAvail().x};
    if (state.inspection != nullptr) {
        scope.keys = keys_in(state.inspection->slot(Slot::keys).bytes);
        scope.before = keys_in(state.inspection->keys_before);
    }
    if (!state.running) {
        scope.pass = shown_pass(stepping);
    }
    if (scope.keys.empty()) {
        dim_text("Waiting for a copy of the keys …");
        return;
    }
    size_choice(scope);
    legend(scope);
    state.view.microscope_options.slots == 0 ? microscope_all(scope) : cells_view(scope);
    microscope_network(scope);
}

}  // namespace ballpit::ui
