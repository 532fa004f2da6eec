// What is thrown into a running scene, and what the hand holds: what the panel shows.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace ballpit::ui {

struct PlayOptions {
    double radius = 0.1;         // m, of a thrown ball
    double density = 1000.0;     // kg/m^3
    double speed = 10.0;         // m/s, of a ball that is shot
    std::uint32_t cluster = 50;  // balls
    bool hand = false;           // the left button takes hold of walls and balls

    friend bool operator==(const PlayOptions&, const PlayOptions&) = default;
};

inline constexpr std::uint32_t largest_cluster = 1000;

struct PlayState {
    PlayOptions options;
    PlayOptions usual;  // as follows from the scene
    bool walls_moved = false;
    std::optional<std::uint32_t> held_ball;
};

}  // namespace ballpit::ui
