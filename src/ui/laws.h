// The laws of the scene that runs: which of them hold and why, and what each was measured to cost.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/laws.h"
#include "core/schedule.h"
#include "core/settings.h"
#include "measure/paired_cost.h"

namespace ballpit::ui {

/// What a law costs in a substep of the present state: the measured one of a law that holds, else what it would add.
struct LawCost {
    measure::PairedCost pairs;
    bool same_programs = false;  // with it and without it the same programs run: nothing to measure
};

struct LawsState {
    std::array<std::optional<LawCost>, law_count> costs;
    bool measuring = false;
    std::uint32_t ball_count = 0;
    double bytes_a_ball = 0.0;
    std::size_t dispatches = 0;          // a substep
    std::optional<double> substep_ms;    // as it is now
    std::vector<std::string> programs;   // of a substep, each once
    std::vector<std::string> on_demand;  // sentences about those that no shipped scene has
};

/// Whether a law's box is ticked, whether it can be changed, and what a viewer should know of that.
struct LawStanding {
    bool holds = false;
    bool locked = false;  // the balls differ: it holds whatever is ticked
    std::string why;      // empty: nothing to say
};

/// `declared`: the scene's own laws; `own_restitutions`: some ball of the scene has a restitution of its own.
LawStanding standing_of(const LawInfo& law, const Laws& laws, const Laws& declared, const Variety& variety,
                        bool own_restitutions);

/// "+0.03 ms ± 0.01, 4 %"; for a law that is off "would be +0.03 ms ± 0.01, +4 %". `now_ms`: a substep as it is.
std::string cost_text(const LawCost& cost, bool holds, double now_ms);

/// "collide for gravity, walls, diagnostics".
std::string program_text(const Program& program);

}  // namespace ballpit::ui
