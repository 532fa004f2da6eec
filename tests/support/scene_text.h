// Scene files as text, with one part of them replaced.
#pragma once

#include <string>

#include "core/scene_file.h"
#include "support/catch.h"
#include "support/input_error.h"

namespace ballpit::test {

/// A valid scene with one part replaced by another.
inline std::string scene_with(const std::string& part, const std::string& replacement) {
    std::string text = R"({
  "name": "N", "about": "A.",
  "box": { "half_extent": [1, 2, 3], "reference_count": 10 },
  "laws": { "gravity": [0, 0, -9.8], "drag": 0.1,
            "contact": { "stiffness": 1000, "restitution": 0.9, "limit_force": true }, "walls": true },
  "time": { "dt": 0.01, "substeps": 4, "integrator": "historical" },
  "balls": [ { "position": [0, 0, 1], "velocity": [1, 0, 0], "radius": 0.5, "mass": 2, "restitution": 0.8 } ],
  "fill": { "count": 7, "radius": [0.1, 0.2], "density": 500, "speed": 3, "region": [[-1, -2, 0], [1, 2, 3]], "seed": 42 }
})";
    const std::size_t at = text.find(part);
    REQUIRE(at != std::string::npos);
    return text.replace(at, part.size(), replacement);
}

/// A scene with these laws.
inline Scene with_laws(const std::string& laws) {
    return parse_scene(R"({"name": "N", "box": {"half_extent": [1, 1, 1]}, "laws": {)" + laws +
                           R"(}, "fill": {"count": 1, "radius": [0.1, 0.1]}})",
                       "s.json");
}

/// What is said of one that is refused.
inline std::string complaint_about_laws(const std::string& laws) {
    return complaint_of([&] { with_laws(laws); });
}

inline std::string complaint(const std::string& text) {
    return complaint_of([&] { parse_scene(text, "s.json"); });
}

inline std::string complaint(const std::string& part, const std::string& replacement) {
    return complaint(scene_with(part, replacement));
}

}  // namespace ballpit::test
