// The keys of the sort under a microscope: cells with their values, arcs for what the last pass compared and swapped,
// and the whole network with a cursor.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "measure/sort_pass.h"
#include "ui/microscope.h"
#include "ui/stepping_panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

const vec3 ascending_colour(0.34f, 0.71f, 0.91f);
const vec3 descending_colour(0.90f, 0.62f, 0.00f);
const vec3 cell_colour(0.16f, 0.19f, 0.225f);
const vec3 selected_colour(1.0f, 0.85f, 0.2f);

struct Scope {
    const State& state;
    const SteppingState& stepping;
    Commands& commands;
    std::span<const Key> keys;
    std::span<const Key> before;  // empty: unknown
    std::optional<ShownPass> pass;
    float width = 0.0f;

    bool compared() const { return pass && before.size() == keys.size(); }
    vec3 direction_colour(bool ascending) const { return ascending ? ascending_colour : descending_colour; }
};

ImDrawList& canvas() { return *ImGui::GetWindowDrawList(); }

std::span<const Key> keys_in(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const Key*>(bytes.data()), bytes.size() / sizeof(Key)};
}

vec3 tint(const Scope& scope, const Key& key) { return scope.state.which_colour(key.ball_id); }

void hatch(const ImVec2& a, const ImVec2& b) {
    canvas().PushClipRect(a, b, true);
    const float step = 0.4f * em();
    for (float x = a.x - (b.y - a.y); x < b.x; x += step) {
        canvas().AddLine(ImVec2(x, b.y), ImVec2(x + (b.y - a.y), a.y), packed(vec3(0.66f, 0.71f, 0.77f), 0.55f), 1.0f);
    }
    canvas().PopClipRect();
}

void arrow_head(const ImVec2& tip, ImU32 colour, float size) {
    canvas().AddTriangleFilled(tip, ImVec2(tip.x - 0.55f * size, tip.y - size),
                               ImVec2(tip.x + 0.55f * size, tip.y - size), colour);
}

// From slot to slot; the head shows where the larger key belongs.
void arc(const Scope& scope, const measure::CompareExchange& pair, float left, float right, float floor, float height) {
    const float alpha = pair.swapped ? 1.0f : 0.42f;
    const ImU32 colour = packed(scope.direction_colour(pair.ascending), alpha);
    const float head = (pair.swapped ? 0.5f : 0.36f) * em();
    const float to = pair.ascending ? right : left;
    const float from = pair.ascending ? left : right;
    const float top = floor - 1.33f * height;
    canvas().AddBezierCubic(ImVec2(from, floor), ImVec2(from, top), ImVec2(to, top), ImVec2(to, floor - 0.8f * head),
                            colour, pair.swapped ? 3.5f : 1.2f);
    arrow_head(ImVec2(to, floor), colour, head);
}

void hovered_slot(const Scope& scope, std::uint32_t slot) {
    tooltip(slot_story(slot, scope.pass, scope.keys, scope.before));
    const Key& key = scope.keys[slot];
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && key.cell_id != SENTINEL) {
        scope.commands.push_back(SelectBall{key.ball_id, true});
    }
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
        arc(scope, pair, row.centre(i), right, floor, height * std::clamp(0.35f + 1.3f * span, 0.0f, 1.0f));
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

// All keys: across the slots, up the cell ids; behind them the blocks that this pass sorts up and down.
void all_view(const Scope& scope) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float height = 7.0f * em();
    const auto count = static_cast<float>(scope.keys.size());
    const auto slot_x = [&](float slot) { return low.x + slot / count * scope.width; };
    canvas().AddRectFilled(low, ImVec2(low.x + scope.width, low.y + height), packed(cell_colour));
    if (scope.pass && static_cast<float>(scope.pass->k) / count * scope.width >= 3.0f) {
        for (std::uint32_t slot = 0; slot < scope.keys.size(); slot += scope.pass->k) {
            const bool ascending = (slot & scope.pass->k) == 0;
            canvas().AddRectFilled(ImVec2(slot_x(static_cast<float>(slot)), low.y),
                                   ImVec2(slot_x(static_cast<float>(slot + scope.pass->k)), low.y + height),
                                   packed(scope.direction_colour(ascending), 0.16f));
        }
    }
    const auto cells = static_cast<float>(std::max(scope.stepping.schedule->cell_count, 1u));
    const auto columns = static_cast<std::size_t>(scope.width);
    constexpr std::size_t most_samples = 64;
    float padding = FLT_MAX;  // where a run of columns with nothing but padding begins
    const auto end_padding = [&](float x) {
        if (padding < x) {
            hatch(ImVec2(padding, low.y), ImVec2(x, low.y + height));
        }
        padding = FLT_MAX;
    };
    for (std::size_t column = 0; column < columns; ++column) {
        const std::size_t first = column * scope.keys.size() / columns;
        const std::size_t last = std::max(first + 1, (column + 1) * scope.keys.size() / columns);
        const std::size_t stride = std::max<std::size_t>(1, (last - first) / most_samples);
        std::uint32_t least = SENTINEL;
        std::uint32_t most = 0;
        std::uint32_t ball = 0;
        for (std::size_t i = first; i < last; i += stride) {
            const Key& key = scope.keys[i];
            if (key.cell_id != SENTINEL) {
                least = std::min(least, key.cell_id);
                most = std::max(most, key.cell_id);
                ball = key.ball_id;
            }
        }
        const float x = low.x + static_cast<float>(column);
        if (least == SENTINEL) {
            padding = std::min(padding, x);
            continue;
        }
        end_padding(x);
        const float top = low.y + height * (1.0f - static_cast<float>(most + 1) / cells);
        const float bottom = low.y + height * (1.0f - static_cast<float>(least) / cells);
        canvas().AddRectFilled(ImVec2(x, top - 0.5f), ImVec2(x + 1.0f, std::max(bottom, top + 1.5f)),
                               packed(scope.state.which_colour(ball)));
    }
    end_padding(low.x + scope.width);
    ImGui::InvisibleButton("all", ImVec2(scope.width, height));
    if (ImGui::IsItemHovered()) {
        const float share = std::clamp((ImGui::GetIO().MousePos.x - low.x) / scope.width, 0.0f, 0.99999f);
        hovered_slot(scope, std::min(static_cast<std::uint32_t>(share * count),
                                     static_cast<std::uint32_t>(scope.keys.size() - 1)));
    }
    dim_text("Left to right: slots. Upwards: cell ids. Hatched: padding.");
}

// ---- the network ------------------------------------------------------------------------------------------------

struct Network {
    std::uint32_t first_dispatch = 0;
    std::vector<ShownPass> passes;
};

Network network_of(const Schedule& schedule) {
    Network network;
    for (std::uint32_t i = 0; i < schedule.dispatches.size(); ++i) {
        const Dispatch& dispatch = schedule.dispatches[i];
        if (dispatch.stage == Stage::bitonic_sort) {
            network.first_dispatch = network.passes.empty() ? i : network.first_dispatch;
            network.passes.push_back({dispatch.constants[0], dispatch.constants[1]});
        }
    }
    return network;
}

// The comparators of one pass on the wires [base, base + wires): within them a line, beyond them a stub.
void comparators(const Scope& scope, const ShownPass& pass, std::uint32_t base, std::uint32_t wires, const ImVec2& low,
                 float column, float wire, bool current, bool past) {
    const std::uint32_t lanes = std::min(pass.j, 8u);
    for (std::uint32_t i = 0; i < wires; ++i) {
        const std::uint32_t slot = base + i;
        const std::uint32_t partner = slot ^ pass.j;
        const bool inside = partner >= base && partner < base + wires;
        if (inside && partner < slot) {
            continue;
        }
        const bool ascending = (slot & pass.k) == 0;
        const float alpha = current ? 1.0f : past ? 0.75f : 0.30f;
        bool swapped = false;
        if (current && scope.compared()) {
            swapped = measure::compare_exchange_of(slot, pass.k, pass.j, scope.before).swapped;
        }
        const float x =
            low.x + column * (0.15f + 0.7f * (static_cast<float>(i % lanes) + 0.5f) / static_cast<float>(lanes));
        const float y = low.y + wire * (static_cast<float>(i) + 0.5f);
        const float end = inside ? low.y + wire * (static_cast<float>(partner - base) + 0.5f)
                                 : y + (partner > slot ? 0.35f : -0.35f) * wire;
        canvas().AddLine(ImVec2(x, y), ImVec2(x, end), packed(scope.direction_colour(ascending), alpha),
                         swapped ? 2.5f : 1.0f);
    }
}

void network_view(const Scope& scope) {
    const Network network = network_of(*scope.stepping.schedule);
    if (network.passes.empty()) {
        return;
    }
    const std::uint32_t wires = std::min<std::uint32_t>(16, static_cast<std::uint32_t>(scope.keys.size()));
    const std::uint32_t base =
        std::min(scope.state.view.microscope_options.first, static_cast<std::uint32_t>(scope.keys.size()) - 1) / wires *
        wires;
    const float wire = 6.2f * em() / 16.0f;
    const float height = wire * static_cast<float>(wires);
    const float labels = 1.1f * em();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float column = scope.width / static_cast<float>(network.passes.size());
    const std::uint32_t ran = scope.stepping.place.ran;
    float labelled = low.x;
    for (std::size_t p = 0; p < network.passes.size(); ++p) {
        const ShownPass& pass = network.passes[p];
        const ImVec2 corner(low.x + column * static_cast<float>(p), low.y);
        const bool current = network.first_dispatch + p + 1 == ran;
        const bool odd = std::countr_zero(pass.k) % 2 == 1;
        canvas().AddRectFilled(corner, ImVec2(corner.x + column, low.y + height),
                               current ? packed(vec3(1.0f), 0.28f) : packed(vec3(0.5f), odd ? 0.10f : 0.04f));
        comparators(scope, pass, base, wires, corner, column, wire, current, network.first_dispatch + p < ran);
        if (current) {
            canvas().AddRect(corner, ImVec2(corner.x + column, low.y + height), packed(text_colour), 0.0f, 0, 1.5f);
        }
        if (pass.j == pass.k / 2) {
            const float group = column * static_cast<float>(std::countr_zero(pass.k));
            const std::string label = (pass.k == 2 ? "k = " : "") + std::to_string(pass.k);
            const float wide = ImGui::CalcTextSize(label.c_str()).x;
            const float x = std::max(corner.x + 0.5f * (group - wide), low.x);
            if (x >= labelled && x + wide <= low.x + scope.width) {
                canvas().AddText(ImVec2(x, low.y + height), packed(dim_colour), label.c_str());
                labelled = x + wide + 0.3f * em();
            }
        }
    }
    const bool clicked = ImGui::InvisibleButton("network", ImVec2(scope.width, height + labels));
    if (!ImGui::IsItemHovered()) {
        return;
    }
    const auto p = std::min(static_cast<std::size_t>(std::max(0.0f, (ImGui::GetIO().MousePos.x - low.x) / column)),
                            network.passes.size() - 1);
    tooltip(format("Pass %zu of %zu: k = %u, j = %u. Click to go there.", p + 1, network.passes.size(),
                   network.passes[p].k, network.passes[p].j));
    if (clicked) {
        Place place = scope.stepping.place;
        place.ran = network.first_dispatch + static_cast<std::uint32_t>(p) + 1;
        scope.commands.push_back(GoTo{place});
    }
}

// ---- the panel --------------------------------------------------------------------------------------------------

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
    state.view.microscope_options.slots == 0 ? all_view(scope) : cells_view(scope);
    network_view(scope);
}

}  // namespace ballpit::ui
