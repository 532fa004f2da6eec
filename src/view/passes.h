// The passes that a picture is drawn in, for who wants to know what each of them costs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>

namespace ballpit::view {

enum class Pass : std::uint8_t {
    visibility,    // which ball each pixel shows, where there are many
    shadows,       // what the light sees
    surroundings,  // background, ground, and what balls darken of it
    balls,
    overlay,  // box, cells, light, arrows, see-through balls, and what else lies over them
};

inline constexpr std::size_t pass_count = 5;
inline constexpr std::array<std::string_view, pass_count> pass_names = {"visibility", "shadows", "surroundings",
                                                                        "balls", "overlay"};

/// Called when everything that belongs to a pass has been handed to the device; each pass once a picture, in order.
using PassMark = std::function<void(Pass)>;

}  // namespace ballpit::view
