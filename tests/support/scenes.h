// The scenes that ship, for tests that run them.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/scene_file.h"

namespace ballpit::test {

inline constexpr std::array<std::string_view, 18> shipped_scene_names = {
    "bench_pile", "cannonball", "column_of_ten",        "cooling_gas", "elastic_gas",    "free_fall",
    "historical", "hot_corner", "kicked_chain",         "mixed_sizes", "newtons_cradle", "oblique_pair",
    "one_cell",   "pile",       "projectile_with_drag", "rain",        "two_balls",      "unequal_pair"};

inline std::filesystem::path source_folder() { return BALLPIT_SOURCE_DIR; }

inline Scene shipped_scene(std::string_view name) {
    return load_scene(source_folder() / "assets" / "scenes" / (std::string(name) + ".json"));
}

/// The seed that the scene starts with.
inline std::uint64_t seed_of(const Scene& scene) { return scene.fill ? scene.fill->seed : 0; }

}  // namespace ballpit::test
