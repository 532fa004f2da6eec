#include "ui/meters_plot.h"

#include <algorithm>
#include <cmath>

#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

// Of Okabe and Ito's palette, in lightness from dark to light, so that neighbours differ without their hue, too.
constexpr std::array<vec3, energy_bands> colours = {vec3(0.00f, 0.45f, 0.70f), vec3(0.34f, 0.71f, 0.91f),
                                                    vec3(0.00f, 0.62f, 0.45f), vec3(0.80f, 0.47f, 0.65f),
                                                    vec3(0.90f, 0.62f, 0.00f), vec3(0.94f, 0.89f, 0.26f)};

constexpr float column_width_px = 2.0f;

struct Axes {
    ImVec2 low;
    ImVec2 size;
    double begin = 0.0;
    double end = 0.0;
    double top = 0.0;

    float y(double energy) const {
        const double share = std::clamp(energy / top, 0.0, 1.0);
        return low.y + size.y * (1.0f - static_cast<float>(share));
    }
};

double sum(const std::array<double, energy_bands>& bands) {
    double total = 0.0;
    for (const double band : bands) {
        total += band;
    }
    return total;
}

double expected(const measure::Balance& balance, double lowest) { return balance.start + balance.work - lowest; }

// The newest point that is not after `time`.
const measure::Balance& at(std::span<const measure::Balance> series, double time) {
    const auto after = std::ranges::upper_bound(series, time, {}, &measure::Balance::time);
    return after == series.begin() ? series.front() : *(after - 1);
}

void draw_column(const Axes& axes, const measure::Balance& balance, double lowest, float x, int number) {
    ImDrawList* list = ImGui::GetWindowDrawList();
    const auto bands = bands_of(balance, lowest);
    double below = 0.0;
    for (std::size_t band = 0; band < energy_bands; ++band) {
        const float bottom = axes.y(below);
        below += bands[band];
        const float top = axes.y(below);
        if (bottom > top) {
            list->AddRectFilled(ImVec2(x, top), ImVec2(x + column_width_px, bottom), band_colour(band));
        }
    }
    const float wanted = axes.y(expected(balance, lowest));
    const float found = axes.y(below);
    if (std::abs(wanted - found) >= 1.0f && number % 2 == 0) {  // every other column: hatched
        list->AddRectFilled(ImVec2(x, std::min(wanted, found)), ImVec2(x + column_width_px, std::max(wanted, found)),
                            unexplained_colour());
    }
    list->AddRectFilled(ImVec2(x, wanted - 1.0f), ImVec2(x + column_width_px, wanted + 1.0f), packed(text_colour));
}

}  // namespace

ImU32 band_colour(std::size_t band) { return packed(colours[band]); }

ImU32 unexplained_colour() { return packed(vec3(0.84f, 0.37f, 0.00f)); }

std::array<double, energy_bands> bands_of(const measure::Balance& b, double lowest) {
    std::array<double, energy_bands> bands = {b.kinetic,   b.potential - lowest, b.elastic,
                                              b.drag_heat, b.contact_heat,       b.wall_heat};
    for (double& band : bands) {
        band = band > 0.0 ? band : 0.0;  // not a number is nothing
    }
    return bands;
}

double lowest_potential(std::span<const measure::Balance> series) {
    double lowest = 0.0;
    for (const measure::Balance& balance : series) {
        lowest = std::min(lowest, balance.potential);
    }
    return lowest;
}

void energy_plot(std::span<const measure::Balance> series, ImVec2 size) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled(low, ImVec2(low.x + size.x, low.y + size.y),
                                              packed(vec3(0.15f, 0.18f, 0.21f)));
    ImGui::Dummy(size);
    if (series.size() < 2) {
        return;
    }
    const double lowest = lowest_potential(series);
    Axes axes{low, size, series.front().time, series.back().time, 0.0};
    for (const measure::Balance& balance : series) {
        const double most = std::max(sum(bands_of(balance, lowest)), expected(balance, lowest));
        axes.top = std::max(axes.top, std::isfinite(most) ? 1.05 * most : 0.0);
    }
    if (!(axes.top > 0.0)) {
        return;
    }
    const int columns = static_cast<int>(size.x / column_width_px);
    for (int i = 0; i < columns; ++i) {
        const double time = axes.begin + (axes.end - axes.begin) * (i + 1) / columns;
        draw_column(axes, at(series, time), lowest, low.x + column_width_px * static_cast<float>(i), i);
    }
    tooltip(
        format("From %.4g s to %.4g s; the top is %.4g J. The white line is the energy that there should be: at the "
               "beginning, and the work since. What lies between it and the bands is unexplained.",
               axes.begin, axes.end, axes.top));
}

}  // namespace ballpit::ui
