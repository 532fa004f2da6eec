// What the parts of the microscope share.
#pragma once

#include <span>

#include "ui/microscope.h"
#include "ui/stepping_panels.h"

namespace ballpit::ui {

inline const vec3 ascending_colour(0.34f, 0.71f, 0.91f);
inline const vec3 descending_colour(0.90f, 0.62f, 0.00f);

inline const vec3 cell_colour(0.16f, 0.19f, 0.225f);

struct Scope {
    const State& state;
    const SteppingState& stepping;
    Commands& commands;
    std::span<const Key> keys;
    std::span<const Key> before;  // empty: unknown
    std::optional<ShownPass> pass;
    float width = 0.0f;

    bool compared() const { return pass && before.size() == keys.size(); }
    static vec3 direction_colour(bool ascending) { return ascending ? ascending_colour : descending_colour; }
};

/// All keys as one picture, and what lies under the pointer.
void microscope_all(const Scope& scope);
/// The whole network for sixteen wires, with a cursor at the pass that ran last; a click on a column goes to its pass.
void microscope_network(const Scope& scope);

/// Padding.
void hatch(const ImVec2& low, const ImVec2& high);
/// The slot under the pointer: tells its story, and a click selects its ball.
void hovered_slot(const Scope& scope, std::uint32_t slot);

}  // namespace ballpit::ui
