// What a viewer may choose that is no physics: plain values that the panels show and commands carry.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/vector.h"

namespace ballpit::ui {

enum class BackendChoice : std::uint8_t { automatic, gpu, cpu, threads };
inline constexpr std::array<std::string_view, 4> backend_choice_names = {"auto", "gpu", "cpu", "threads"};

/// Automatic: the model, or simple where a CPU draws.
enum class Look : std::uint8_t { automatic, model, impostor, simple };
/// What an automatic look is, where a CPU draws (`software`) or a GPU.
constexpr Look drawn_look(Look look, bool software) {
    return look != Look::automatic ? look : software ? Look::simple : Look::model;
}
enum class BallColour : std::uint8_t { tinted, plain, speed, cell, slot, contacts, radius, difference };
inline constexpr std::size_t ball_colours = 8;
/// Whether the colour is a number that is read back and worked out first.
constexpr bool is_worked_out(BallColour colour) { return colour >= BallColour::slot; }

struct MicroscopeOptions {
    std::uint32_t slots = 16;  // shown at once; 0: all
    std::uint32_t first = 0;   // the window begins at or near this slot

    friend bool operator==(const MicroscopeOptions&, const MicroscopeOptions&) = default;
};

struct ViewOptions {
    Look look = Look::automatic;
    BallColour colour = BallColour::tinted;
    bool box = true;
    bool ground = true;
    bool light = true;
    bool occupancy = false;
    bool timings = false;
    bool laws = false;
    bool meters = false;
    bool budget = false;
    bool explorer = false;
    bool costs = false;
    bool panels = true;
    bool help = false;
    bool stepper = false;
    bool microscope = false;
    MicroscopeOptions microscope_options;

    friend bool operator==(const ViewOptions&, const ViewOptions&) = default;
};

struct LightOptions {
    bool orbiting = true;
    float angle = 0.0f;     // rad about z
    float distance = 0.6f;  // of the box's half width
    float height = 1.4f;    // of the box's largest half extent, above its centre
    float speed = 0.25f;    // rad/s
    vec3 colour{1.0f};      // as on screen (sRGB), 0 to 1
    float brightness = 1.0f;
    float ambient = 0.35f;

    friend bool operator==(const LightOptions&, const LightOptions&) = default;
};

inline constexpr double slowest_time = 0.01;
inline constexpr double fastest_time = 10.0;
inline constexpr float smallest_text = 0.75f;
inline constexpr float largest_text = 2.0f;

}  // namespace ballpit::ui
