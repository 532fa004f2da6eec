#include "ui/laws.h"

#include <algorithm>
#include <cmath>

#include "ui/probe.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

// What a law needs beside itself to do anything; empty: nothing.
std::string missing_partner(bool Laws::*law, const Laws& laws) {
    const bool touching = laws.contact || laws.walls;
    const bool needs_touch = law == &Laws::restitution || law == &Laws::unequal_radii || law == &Laws::unequal_masses ||
                             law == &Laws::ball_restitution;
    if (needs_touch && !touching) {
        return "Does nothing without contact or walls.";
    }
    return law == &Laws::shake && !laws.walls ? "Does nothing without walls." : "";
}

struct Sameness {
    bool differ;
    std::string differing;  // what a viewer reads where the balls differ
    std::string alike;      // and where they do not
};

std::optional<Sameness> sameness_of(bool Laws::*law, const Variety& variety, bool own_restitutions) {
    if (law == &Laws::unequal_radii) {
        return Sameness{variety.radii, "The balls differ in radius.",
                        "All balls have radius " + short_number(static_cast<double>(variety.radius)) + " m."};
    }
    if (law == &Laws::unequal_masses) {
        return Sameness{variety.masses, "The balls differ in mass.",
                        "All balls have mass " + short_number(static_cast<double>(variety.mass)) + " kg."};
    }
    if (law == &Laws::ball_restitution) {
        return Sameness{own_restitutions, "Some balls have a restitution of their own.",
                        "No ball has a restitution of its own."};
    }
    return std::nullopt;
}

std::string signed_ms(double ms) {
    const double size = std::abs(ms);
    return format(size >= 10.0 ? "%+.1f ms" : size >= 0.1 ? "%+.2f ms" : size >= 0.01 ? "%+.3f ms" : "%+.4f ms", ms);
}

std::string feature_name(std::string_view define) {
    for (const std::string_view prefix : {"LAW_", "INTEGRATOR_", "NEIGHBOURS_"}) {
        if (define.starts_with(prefix)) {
            define.remove_prefix(prefix.size());
        }
    }
    std::string name;
    for (const char letter : define) {
        name += letter == '_' ? ' ' : static_cast<char>(letter - 'A' + 'a');
    }
    return name;
}

}  // namespace

LawStanding standing_of(const LawInfo& law, const Laws& laws, const Laws& declared, const Variety& variety,
                        bool own_restitutions) {
    LawStanding standing;
    standing.holds = laws.*law.member;
    const std::string missing = missing_partner(law.member, laws);
    if (const auto sameness = sameness_of(law.member, variety, own_restitutions)) {
        standing.locked = sameness->differ;
        standing.why = sameness->differ ? sameness->differing
                       : standing.holds ? sameness->alike + " Ticked all the same: no bit of the result changes."
                                        : sameness->alike;
        standing.holds |= sameness->differ;
    } else if (!standing.holds) {
        standing.why =
            declared.*law.member ? "The scene declares it; it is ticked off." : "The scene does not declare it.";
    } else if (!(declared.*law.member)) {
        standing.why = "The scene does not declare it; it is ticked on.";
    }
    if (!missing.empty()) {
        standing.why += (standing.why.empty() ? "" : " ") + missing;
    }
    return standing;
}

std::string cost_text(const LawCost& cost, bool holds, double now_ms) {
    if (cost.same_programs) {
        return "nothing: the same programs run";
    }
    const measure::PairedCost& pairs = cost.pairs;
    const std::string range = format(pairs.uncertainty >= 10.0 ? " ± %.0f ms" : " ± %.2g ms", pairs.uncertainty);
    if (!pairs.known) {
        return "less than can be told:" + range;
    }
    const double share = now_ms > 0.0 ? 100.0 * pairs.ms / now_ms : 0.0;
    const std::string percent = format(holds ? "%.0f %%" : "%+.0f %%", share);
    return (holds ? "" : "would be ") + signed_ms(pairs.ms) + range + ", " + percent;
}

std::string program_text(const Program& program) {
    std::string laws;
    for (std::size_t bit = 0; bit < feature_defines.size(); ++bit) {
        if ((program.features.bits >> bit & 1u) != 0) {
            laws += (laws.empty() ? " for " : ", ") + feature_name(feature_defines[bit]);
        }
    }
    return std::string(shader_name(program.shader)) + laws;
}

}  // namespace ballpit::ui
