// The bitonic network, a column a pass.
#include <algorithm>
#include <bit>
#include <string>
#include <vector>

#include "measure/sort_pass.h"
#include "ui/microscope_scope.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

ImDrawList& canvas() { return *ImGui::GetWindowDrawList(); }

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
        canvas().AddLine(ImVec2(x, y), ImVec2(x, end), packed(Scope::direction_colour(ascending), alpha),
                         swapped ? 2.5f : 1.0f);
    }
}

}  // namespace

void microscope_network(const Scope& scope) {
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

}  // namespace ballpit::ui
