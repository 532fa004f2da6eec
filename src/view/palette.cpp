#include "view/palette.h"

#include <algorithm>
#include <cmath>

namespace ballpit::view {

namespace {

constexpr vec3 rgb(int red, int green, int blue) {
    return {static_cast<float>(red) / 255.0f, static_cast<float>(green) / 255.0f, static_cast<float>(blue) / 255.0f};
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

vec3 sequential(float t) {
    constexpr auto last = static_cast<float>(std::tuple_size_v<decltype(sequential_palette)> - 1);
    const float place = std::isnan(t) ? 0.0f : std::clamp(t, 0.0f, 1.0f) * last;
    const float below = std::min(std::floor(place), last - 1.0f);
    const auto index = static_cast<std::size_t>(below);
    return glm::mix(sequential_palette[index], sequential_palette[index + 1], place - below);
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
