#include "ui/stage_sentence.h"

#include <algorithm>

#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

std::string counted(std::uint64_t count, const char* one, const char* many) {
    return grouped(count) + " " + (count == 1 ? one : many);
}

struct Teller {
    std::string operator()(std::monostate) const { return {}; }

    std::string operator()(const measure::AssignNumbers& n) const {
        std::string words = "Cells assigned: " + counted(n.balls, "ball lies in ", "balls lie in ") +
                            grouped(n.occupied) + " of " + counted(n.cells, "cell", "cells");
        words += n.outside == 0 ? ", none outside the box" : "; " + grouped(n.outside) + " outside the box";
        return words +
               (n.padding == 0 ? "." : "; " + counted(n.padding, "key pads", "keys pad") + " to a power of two.");
    }

    std::string operator()(const measure::SortNumbers& n) const {
        std::string words =
            format("Sort pass %u of %u: k = %s, j = %s", n.pass, n.passes, grouped(n.k).c_str(), grouped(n.j).c_str());
        if (n.swapped) {
            words += "; " + grouped(*n.swapped) + " of " + counted(n.pairs, "pair", "pairs") + " swapped";
        }
        return words + ".";
    }

    std::string operator()(const measure::ClearNumbers& n) const {
        return "Cell table emptied: " + counted(n.cells, "cell holds", "cells hold") + " no slots now.";
    }

    std::string operator()(const measure::BuildNumbers& n) const {
        std::string words =
            "Grid built: " + grouped(n.occupied) + " of " + counted(n.cells, "cell", "cells") + " occupied";
        if (n.most > 0) {
            words += "; the fullest, cell " + grouped(n.fullest) + ", holds " + counted(n.most, "ball", "balls");
        }
        return words + ".";
    }

    std::string operator()(const measure::CollideNumbers& n) const {
        std::string words = "Balls moved: ";
        if (n.contacts) {
            words += counted(*n.contacts, "contact", "contacts");
            words += *n.contacts > 0 ? ", largest overlap " + length_text(static_cast<double>(n.largest_overlap)) : "";
        } else {
            words += "contacts not counted for so many balls";
        }
        if (n.fastest) {
            words +=
                format("; fastest: ball %s at %.3g m/s", grouped(*n.fastest).c_str(), static_cast<double>(n.top_speed));
        }
        return words + (n.not_finite == 0 ? "." : "; " + grouped(n.not_finite) + " without a number for a speed.");
    }
};

}  // namespace

std::string length_text(double metres) {
    return metres >= 1.0    ? format("%.3g m", metres)
           : metres >= 1e-3 ? format("%.3g mm", 1e3 * metres)
                            : format("%.3g µm", 1e6 * metres);
}

std::string stage_sentence(const measure::StageNumbers& numbers) { return std::visit(Teller{}, numbers); }

std::string place_text(const SteppingState& stepping) {
    const Place& place = stepping.place;
    return "Step " + grouped(place.substep.step + 1) +
           format(", substep %u of %u, dispatch %u of %u", place.substep.substep + 1,
                  std::max(stepping.substeps, place.substep.substep + 1), place.ran,
                  static_cast<unsigned>(stepping.schedule->dispatches.size()));
}

}  // namespace ballpit::ui
