#include "core/laws.h"

#include <algorithm>

#include "core/error.h"

namespace ballpit {

namespace {

constexpr std::array<LawInfo, law_count> table = {{
    {"gravity", "Gravity", &Laws::gravity, "Every ball is accelerated alike.", "Arithmetic only."},
    {"drag", "Drag", &Laws::drag, "Speed decays by the exact factor exp(-drag t).", "Arithmetic only."},
    {"contact", "Contact", &Laws::contact, "Balls that overlap push each other apart like springs.",
     "Keys, sort, cell table, a second state buffer, and the positions of all balls in 27 cells."},
    {"restitution", "Restitution", &Laws::restitution, "A dashpot takes energy out of every contact.",
     "The velocity of every ball that is touched."},
    {"walls", "Walls", &Laws::walls, "Six half-spaces hold the balls in the box.", "Arithmetic only."},
    {"shake", "Shake", &Laws::shake, "The box swings, and its walls' velocity enters the dashpot.",
     "Constants that change in every substep."},
    {"unequal_radii", "Unequal radii", &Laws::unequal_radii, "Each ball has the radius beside its position.",
     "No constant radius."},
    {"unequal_masses", "Unequal masses", &Laws::unequal_masses, "Each ball has the mass beside its velocity.",
     "No constant mass."},
    {"ball_restitution", "Restitution per ball", &Laws::ball_restitution,
     "A pair has the smaller restitution of its two balls.", "A buffer of 4 B a ball, read for every ball touched."},
    {"diagnostics", "Diagnostics", &Laws::diagnostics,
     "Stages count what goes wrong, and hold balls that are no number.", "A status word, and tests of every ball."},
    {"compensated", "Compensated sums", &Laws::compensated,
     "What rounding leaves out of positions and velocities is kept and added later: a step can be as short as you "
     "like.",
     "24 B a ball, read and written in every substep."},
}};

}  // namespace

std::span<const LawInfo, law_count> law_table() { return table; }

std::string laws_text(const Laws& laws) {
    std::string text;
    for (const LawInfo& info : table) {
        if (laws.*info.member) {
            text += (text.empty() ? "" : ",") + std::string(info.key);
        }
    }
    return text.empty() ? "none" : text;
}

Laws parse_laws(std::string_view text) {
    Laws laws;
    laws.diagnostics = false;
    if (text == "none") {
        return laws;
    }
    std::size_t start = 0;
    while (start <= text.size()) {
        const std::size_t comma = std::min(text.find(',', start), text.size());
        const std::string_view key = text.substr(start, comma - start);
        const auto found = std::ranges::find(table, key, &LawInfo::key);
        if (found == table.end()) {
            Laws all;
            for (const LawInfo& info : table) {
                all.*info.member = true;
            }
            throw InputError("there is no law '" + std::string(key) + "': expected none, or some of " + laws_text(all));
        }
        laws.*found->member = true;
        start = comma + 1;
    }
    return laws;
}

}  // namespace ballpit
