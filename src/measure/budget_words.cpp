#include "measure/budget_words.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>

namespace ballpit::measure {

namespace {

constexpr double firm = 0.05;  // diameters: an overlap that nobody sees

std::string number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g", value);
    return text.data();
}

// 12345 rather than 1.23e+04.
std::string whole(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.0f", value);
    return text.data();
}

std::string percent(double share) { return number(100.0 * share) + " %"; }

std::string demand_words(const BudgetQuestion& question, const Rung& rung, Demand demand) {
    switch (demand) {
        case Demand::restitution:
            return "restitution off by " + percent(rung.restitution) + " (" + percent(question.budget.restitution) +
                   " allowed)";
        case Demand::overlap:
            return "overlap off by " + percent(rung.overlap) + " of a diameter (" + percent(question.budget.overlap) +
                   " allowed)";
        case Demand::energy:
            return "energy off by " + percent(rung.energy) + " a second (" + percent(question.budget.energy) +
                   " allowed)";
        case Demand::stability:
            return "a substep of " + number(0.9 * rung.shares[static_cast<std::size_t>(demand)]) +
                   " of the critical one (0.9 allowed)";
        case Demand::resolution:
            return number(6.0 / rung.shares[static_cast<std::size_t>(demand)]) + " substeps a contact (6 wanted)";
        case Demand::sampling:
            break;
    }
    return "the fastest ball moves " + number(0.25 * rung.shares[static_cast<std::size_t>(Demand::sampling)]) +
           " of a diameter a substep (0.25 allowed)";
}

const Rung* tried(const BudgetChoice& choice, std::uint32_t substeps) {
    const auto found = std::ranges::find(choice.tried, substeps, &Rung::substeps);
    return found == choice.tried.end() ? nullptr : &*found;
}

std::string counted(std::uint32_t substeps) {
    return std::to_string(substeps) + (substeps == 1 ? " substep" : " substeps");
}

std::string capital(std::string_view name) {
    std::string words(name);
    words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
    return words;
}

std::string name(Integrator integrator) { return std::string(integrator_names[static_cast<std::size_t>(integrator)]); }

// Why it is not fewer: the next cheaper count that was tried.
std::string why(const BudgetQuestion& question, const BudgetChoice& choice) {
    if (!choice.binding) {
        return "";
    }
    const Rung* fewer = nullptr;
    for (const Rung& rung : choice.tried) {
        if (rung.substeps < choice.substeps) {
            fewer = &rung;
        }
    }
    if (fewer == nullptr) {
        return "";
    }
    const double share = fewer->shares[static_cast<std::size_t>(*choice.binding)];
    const Rung* blamed = share > 1.0 ? fewer : tried(choice, 2 * fewer->substeps);
    return blamed == nullptr
               ? ""
               : ". " + capital(demand_names[static_cast<std::size_t>(*choice.binding)]) + " decides: with " +
                     std::to_string(blamed->substeps) + ", " + demand_words(question, *blamed, *choice.binding);
}

std::string result(const BudgetQuestion& question, const BudgetChoice& choice) {
    const Rung& rung = choice.measured;
    const std::string errors = "restitution off by " + percent(rung.restitution) + ", largest overlap by " +
                               percent(rung.overlap) + " of a diameter, energy by " + percent(rung.energy) +
                               " a second";
    const std::string head = counted(choice.substeps) + " with " + name(choice.integrator) + ": " + errors;
    if (question.historical) {
        return head + (choice.met ? "" : "; more than 1 %");
    }
    if (choice.met) {
        return head + why(question, choice);
    }
    const std::uint32_t most = choice.tried.empty() ? choice.substeps : choice.tried.back().substeps;
    return "No count up to " + std::to_string(std::max(most, choice.substeps)) +
           " meets the budget. The nearest: " + head +
           (choice.binding ? "; what is missed most: " + demand_words(question, rung, *choice.binding) : "");
}

// Which network the critical substep is of.
std::string limit_words(const BudgetQuestion& question, const BudgetChoice& choice) {
    if (question.historical) {
        return "";
    }
    const bool balls = question.probe.settings.laws.contact;
    return ". The critical substep, " + number(1000.0 * choice.critical_dt) + " ms, is that of " +
           (choice.network_measured ? "the contacts as they are"
            : balls                 ? "twelve neighbours a ball: too few touch to tell"
                                    : "a ball at a wall");
}

// Costs go with the count of balls, and with the frequency of contacts: the root of the stiffness, the power -3/2 of
// the radius (mass).
std::string fit(const BudgetQuestion& question, const BudgetChoice& choice) {
    if (!question.substep_ms) {
        return "";
    }
    const Settings& settings = question.probe.settings;
    const double cost = choice.substeps * *question.substep_ms;
    const double step = 1000.0 * settings.dt;
    std::string takes = ". It takes " + number(cost) + " ms of a step's " + number(step) + " ms";
    if (cost <= step) {
        return takes;
    }
    const double ratio = step / cost;
    std::string words = takes + "; to fit, about " + whole(std::floor(settings.balls * ratio)) + " balls";
    if (choice.binding != Demand::sampling) {
        words += ", a stiffness of " + number(settings.stiffness * ratio * ratio) + " N/m or balls " +
                 number(std::pow(1.0 / ratio, 2.0 / 3.0)) + " times as large";
    } else {
        words += " or balls " + number(1.0 / ratio) + " times as large";
    }
    return words + " would do";
}

std::string floor_words(const BudgetQuestion& question, const BudgetChoice& choice) {
    if (choice.floor == 0 || choice.met || choice.floor >= 1024 || question.historical) {
        return "";
    }
    return ". More than " + std::to_string(choice.floor) +
           " only add rounding: " + number(question.probe.scene.distance) + " m from the origin floats are too coarse" +
           "; the law compensated goes further";
}

std::string soft_words(const BudgetQuestion& question, const BudgetChoice& choice) {
    if (choice.softness < 0.9) {
        return "";
    }
    return ". At " + number(question.probe.scene.largest_speed) +
           " m/s balls pass through each other, which no count changes: " +
           number(firm_stiffness(question, choice.softness)) + " N/m would keep overlaps to a twentieth";
}

}  // namespace

std::string nothing_sentence(const std::string& why, const BudgetChoice& choice) {
    return why + "; " + counted(choice.substeps) + " as before";
}

double firm_stiffness(const BudgetQuestion& question, double softness) {
    const double ratio = softness / firm;
    return question.probe.settings.stiffness * ratio * ratio;
}

std::string budget_sentence(const BudgetQuestion& question, const BudgetChoice& choice) {
    return result(question, choice) + limit_words(question, choice) + fit(question, choice) +
           floor_words(question, choice) + soft_words(question, choice);
}

}  // namespace ballpit::measure
