#include "view/palette.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>

namespace ballpit::view {

namespace {

constexpr vec3 rgb(int red, int green, int blue) {
    return {static_cast<float>(red) / 255.0f, static_cast<float>(green) / 255.0f, static_cast<float>(blue) / 255.0f};
}

constexpr std::size_t steps = 9;  // colours of a palette for "how much"

vec3 between(const std::array<vec3, steps>& palette, float t) {
    constexpr auto last = static_cast<float>(steps - 1);
    const float place = std::isnan(t) ? 0.0f : std::clamp(t, 0.0f, 1.0f) * last;
    const float below = std::min(std::floor(place), last - 1.0f);
    const auto index = static_cast<std::size_t>(below);
    return glm::mix(palette[index], palette[index + 1], place - below);
}

// 1, 2 or 5 times a power of ten: the smallest that gives at most six ticks.
struct TickStep {
    double step;
    int exponent;  // of ten
};

TickStep tick_step(double low, double high) {
    constexpr double most_ticks = 6.0;
    auto exponent = static_cast<int>(std::floor(std::log10((high - low) / most_ticks)));
    for (;; ++exponent) {
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double step = digit * std::pow(10.0, exponent);
            if (std::floor(high / step) - std::ceil(low / step) + 1.0 <= most_ticks) {
                return {step, exponent};
            }
        }
    }
}

std::string tick_text(double value, int exponent) {
    constexpr int longest = 5;  // digits before or after the point
    const bool plain = std::abs(exponent) < longest && std::abs(value) < std::pow(10.0, longest);
    std::array<char, 64> text{};
    if (plain) {
        std::snprintf(text.data(), text.size(), "%.*f", std::max(0, -exponent), value);
    } else {
        std::snprintf(text.data(), text.size(), "%.4g", value);
    }
    return text.data();
}

}  // namespace

const std::array<vec3, 8> categorical_palette = {rgb(230, 159, 0),   rgb(86, 180, 233), rgb(0, 158, 115),
                                                 rgb(240, 228, 66),  rgb(0, 114, 178),  rgb(213, 94, 0),
                                                 rgb(204, 121, 167), rgb(187, 187, 187)};

// A straight line in Oklab (Ottosson 2020) from the first colour to the last.
const std::array<vec3, 9> sequential_palette = {rgb(52, 108, 216),  rgb(76, 128, 208),  rgb(100, 146, 199),
                                                rgb(125, 163, 188), rgb(150, 179, 176), rgb(176, 195, 161),
                                                rgb(202, 209, 142), rgb(228, 224, 117), rgb(255, 238, 80)};

vec3 categorical(std::uint32_t index) { return categorical_palette[index % categorical_palette.size()]; }

// Two straight lines in Oklab that meet in a pale grey; both ends have the same lightness.
const std::array<vec3, 9> diverging_palette = {rgb(45, 123, 239),  rgb(98, 154, 242),  rgb(145, 184, 242),
                                               rgb(192, 211, 240), rgb(239, 238, 236), rgb(235, 202, 185),
                                               rgb(228, 165, 133), rgb(218, 128, 80),  rgb(206, 87, 0)};

const vec3 no_value_colour = rgb(110, 112, 116);

vec3 sequential(float t) { return between(sequential_palette, t); }

vec3 diverging(float t) { return between(diverging_palette, t); }

vec3 value_colour(Palette palette, float value, float low, float high) {
    if (std::isnan(value)) {
        return no_value_colour;
    }
    if (palette == Palette::categorical) {
        return value >= 0.0f && value < 4294967040.0f ? categorical(static_cast<std::uint32_t>(value))
                                                      : no_value_colour;
    }
    const float t = (value - low) / std::max(high - low, 1e-30f);
    return palette == Palette::diverging ? diverging(t) : sequential(t);
}

std::vector<LegendEntry> categorical_legend(std::span<const std::string> names) {
    std::vector<LegendEntry> legend;
    for (const std::string& name : names) {
        legend.push_back({categorical(static_cast<std::uint32_t>(legend.size())), name});
    }
    return legend;
}

ContinuousLegend continuous_legend(Palette palette, float low, float high, std::string_view unit) {
    assert(palette != Palette::categorical);
    const auto& colours = palette == Palette::diverging ? diverging_palette : sequential_palette;
    ContinuousLegend legend{{colours.begin(), colours.end()}, {}};
    if (!std::isfinite(low) || !std::isfinite(high) || low >= high) {
        return legend;
    }
    const TickStep chosen = tick_step(low, high);
    for (double n = std::ceil(low / chosen.step); n <= std::floor(high / chosen.step); ++n) {
        const double value = n * chosen.step;
        legend.ticks.push_back(
            {static_cast<float>((value - low) / (static_cast<double>(high) - low)), tick_text(value, chosen.exponent)});
    }
    if (!unit.empty() && !legend.ticks.empty()) {
        legend.ticks.back().text.append(" ").append(unit);
    }
    return legend;
}

vec3 linear_from_srgb(const vec3& colour) {
    const auto channel = [](float c) { return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); };
    return {channel(colour.x), channel(colour.y), channel(colour.z)};
}

vec3 srgb_from_linear(const vec3& colour) {
    const auto channel = [](float c) {
        return c <= 0.0031308f ? c * 12.92f : 1.055f * std::pow(c, 1.0f / 2.4f) - 0.055f;
    };
    return {channel(colour.x), channel(colour.y), channel(colour.z)};
}

}  // namespace ballpit::view
