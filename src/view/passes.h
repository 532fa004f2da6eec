// The passes that a picture is drawn in, for who wants to know what each of them costs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>

namespace ballpit::view {

enum class Pass : std::uint8_t {
    shadows,       // what the light sees
    surroundings,  // background, ground, and what balls darken of it
    balls,
    overlay,  // box, cells, light, arrows, see-through balls, and what else lies over them
};

inline constexpr std::size_t pass_count = 4;
inline constexpr std::array<std::string_view, pass_count> pass_names = {"shadows", "surroundings", "balls", "overlay"};

/// Called when everything that belongs to a pass has been handed to the device; each pass once a picture, in order.
using PassMark = std::function<void(Pass)>;

}  // namespace ballpit::view
