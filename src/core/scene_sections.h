// The parts of a scene file that hold settings: box, laws, time, compute, resume, bounds.
#pragma once

#include "core/json_document.h"
#include "core/scene.h"

namespace ballpit {

// What single precision can still compute with: beyond these, forces overflow or positions stand still.
inline constexpr double smallest_length = 1e-3;  // m
inline constexpr double largest_length = 1e4;    // m
inline constexpr double smallest_mass = 1e-12;   // kg: that of the smallest ball of the lightest fill is larger
inline constexpr double largest_mass = 1e19;     // kg: that of the largest ball of the densest fill is smaller
inline constexpr double largest_speed = 1e6;     // m/s
inline constexpr double largest_number = 1e30;   // m, m/s: of a saved moment

/// Each reads the value of the key in its name into the scene. Throws InputError (json_document.h).
void read_box(const JsonValue& box, Scene& scene);
void read_laws(const JsonValue& laws, Scene& scene);
void read_time(const JsonValue& time, Scene& scene);
void read_compute(const JsonValue& compute, Scene& scene);
void read_resume(const JsonValue& value, Scene& scene);
void read_bounds(const JsonValue& value, Scene& scene);

/// A number in the range of the setting with this key.
double read_setting(const JsonValue& value, std::string_view key);

}  // namespace ballpit
