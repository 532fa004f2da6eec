#include "ui/occupancy_panel.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "ui/panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

constexpr std::size_t single_bars = 16;

std::string bar_label(const HistogramBar& bar) {
    return bar.first == bar.last ? std::to_string(bar.first)
                                 : std::to_string(bar.first) + "–" + std::to_string(bar.last);
}

void centred(const std::string& words, float x, float y, ImU32 colour) {
    const float width = ImGui::CalcTextSize(words.c_str()).x;
    ImGui::GetWindowDrawList()->AddText(ImVec2(x - 0.5f * width, y), colour, words.c_str());
}

// Bars are coloured as the cells in the picture: the plot is the legend too.
void histogram_plot(const State& state, const std::vector<HistogramBar>& bars) {
    const float line = ImGui::GetTextLineHeight();
    const ImVec2 size(24.0f * em(), 6.0f * em());
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float floor = low.y + size.y - line;
    const float step = std::min(size.x / static_cast<float>(bars.size()), 4.0f * em());
    const float gap = std::min(0.15f * step, 3.0f);
    std::uint64_t most = 1;
    for (const HistogramBar& bar : bars) {
        most = std::max(most, bar.cells);
    }
    for (std::size_t i = 0; i < bars.size(); ++i) {
        const HistogramBar& bar = bars[i];
        const float x = low.x + step * static_cast<float>(i);
        const double share = static_cast<double>(bar.cells) / static_cast<double>(most);
        const float height = bar.cells == 0 ? 0.0f : std::max(2.0f, static_cast<float>(share) * (size.y - 2.2f * line));
        const float amount = (static_cast<float>(bar.last) - 1.0f) / (static_cast<float>(state.top_count) - 1.0f);
        const ImVec2 corner(x + gap, floor - height);
        const ImVec2 opposite(x + step - gap, floor);
        ImGui::GetWindowDrawList()->AddRectFilled(corner, opposite, packed(state.amount_colour(amount)));
        if (height > 0.0f) {  // the darkest colours would be lost on the panel
            ImGui::GetWindowDrawList()->AddRect(corner, opposite, packed(dim_colour));
        }
        const std::string cells = std::to_string(bar.cells);
        if (bar.cells > 0 && ImGui::CalcTextSize(cells.c_str()).x <= step) {
            centred(cells, x + 0.5f * step, floor - height - line, packed(text_colour));
        }
        const std::string label = bar_label(bar);
        const bool fits = ImGui::CalcTextSize(label.c_str()).x <= step - 2.0f;
        if (fits || i == 0 || i + 1 == bars.size()) {
            const float half = 0.5f * ImGui::CalcTextSize(label.c_str()).x;
            const float centre = std::clamp(x + 0.5f * step, low.x + half, low.x + std::max(half, size.x - half));
            centred(label, centre, floor, packed(dim_colour));
        }
    }
    ImGui::Dummy(size);
}

}  // namespace

std::vector<HistogramBar> histogram_bars(std::span<const std::uint32_t> histogram, std::size_t most_singles) {
    std::vector<HistogramBar> bars;
    const std::size_t longest = histogram.empty() ? 0 : histogram.size() - 1;
    const bool single = longest <= most_singles;
    std::size_t first = 1;
    for (std::size_t end = 1; first <= longest; end = single ? end + 1 : 2 * end) {
        const std::size_t last = std::min(end, longest);
        HistogramBar bar{static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last), 0};
        for (std::size_t count = first; count <= last; ++count) {
            bar.cells += histogram[count];
        }
        bars.push_back(bar);
        first = last + 1;
    }
    return bars;
}

void occupancy_panel(const State& state) {
    text("Cell occupancy");
    ImGui::SameLine();
    dim_text(key_hint(Action::toggle_occupancy));
    if (!state.has_grid) {
        dim_text("This scene has no contacts, so it needs no cells.");
        return;
    }
    if (state.occupancy == nullptr) {
        dim_text("Waiting for the first copy of the cells …");
        return;
    }
    const measure::Occupancy& occupancy = *state.occupancy;
    dim_text(format("occupied %s   mean %.2f   max %s   width %.3g m", grouped(occupancy.occupied).c_str(),
                    occupancy.mean_occupied, grouped(occupancy.max).c_str(), state.cell_width));
    const auto bars = histogram_bars(occupancy.histogram, single_bars);
    if (!bars.empty()) {
        histogram_plot(state, bars);
        dim_text("cells (height) that hold so many balls (below)");
    }
}

}  // namespace ballpit::ui
