// From allowed errors to the cheapest substep count: a first guess by formula, then the probe of single collisions at
// this count and at twice as many, so that no lucky phase decides. docs/accuracy.md has the rule.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "measure/collision_probe.h"

namespace ballpit::measure {

struct ErrorBudget {
    double restitution = 0.01;  // by which e may be off: a share of the approach speed
    double overlap = 0.01;      // by which the largest overlap may be off: diameters of the smallest ball
    double energy = 0.01;       // 1/s: share of the kinetic energy that time steps may make or eat (energy_drift)

    friend bool operator==(const ErrorBudget&, const ErrorBudget&) = default;
};

enum class BudgetPreset : std::uint8_t { fast, balanced, accurate, historical };
inline constexpr std::array<std::string_view, 4> budget_preset_names = {"fast", "balanced", "accurate", "historical"};

/// What the preset promises, as a clause.
std::string_view budget_preset_meaning(BudgetPreset preset);

/// 10 %, 1 %, 0.1 % of each. The historical one promises nothing: its budget is what is shown beside it, 1 %.
ErrorBudget budget_of(BudgetPreset preset);

/// Which demand decides over the count.
enum class Demand : std::uint8_t { restitution, overlap, energy, stability, resolution, sampling };
inline constexpr std::size_t demand_count = 6;
inline constexpr std::array<std::string_view, demand_count> demand_names = {
    "restitution", "overlap", "energy", "stability", "substeps a contact", "speed"};

/// What a count leaves, as shares of what is allowed: 1 is the limit. Stability allows 0.9 of the critical substep,
/// resolution asks for 6 substeps a contact, sampling for a fourth of a diameter a substep at the largest speed.
using Shares = std::array<double, demand_count>;

/// A count of substeps, measured.
struct Rung {
    std::uint32_t substeps = 0;
    bool probed = false;  // else the formulas alone refused it, and the next three are 0
    double restitution = 0.0;
    double overlap = 0.0;
    double energy = 0.0;  // 1/s
    Shares shares{};
    bool meets = false;
};

struct BudgetChoice {
    std::uint32_t substeps = 1;
    Integrator integrator = Integrator::leapfrog;
    bool met = false;               // else the best there is
    bool nothing = false;           // nothing touches: the count is left as it was
    std::optional<Demand> binding;  // none: one substep is enough
    Rung measured;                  // at this count
    std::vector<Rung> tried;        // by count
    std::uint32_t floor = 0;        // more substeps than this only add rounding; 0: no such floor
    double critical_dt = 0.0;       // s
    bool network_measured = false;  // that is of the contacts as they are; else of neighbours to be expected
    double softness = 0.0;          // the largest exact overlap, in diameters
    std::string sentence;           // what was chosen and why
};

/// What is asked for.
struct BudgetQuestion {
    ProbeQuestion probe;  // its substeps and integrator are those that run now
    ErrorBudget budget;
    bool historical = false;              // the settings of the project that this one started from, measured
    std::optional<MeterReading> reading;  // of the balls as they are, where they were metered
    std::optional<double> substep_ms;     // what a substep takes, where it is known
};

BudgetQuestion budget_question(const ProbeQuestion& probe, BudgetPreset preset);

/// Of two typical balls of the scene.
double damping_ratio(const ProbeQuestion& question);

/// Whether critical_dt() is that of the reading: there are two contacts a ball, as in a network that holds itself, or
/// its stiffest ball is stiffer than what is assumed. A few that touch say nothing of a pile that still falls.
bool measures_network(const BudgetQuestion& question);

/// s: the largest stable substep (stability.h), of the reading where measures_network(), else with sqrt(8 k / m):
/// twelve neighbours, close packed; sqrt(k / m) where balls touch walls alone.
double critical_dt(const BudgetQuestion& question);

/// 1/s: rates of collisions times what one of them makes or eats of the energy that takes part, a third of a ball's
/// with another ball and two thirds with a wall. Where dashpots take the energy away sooner than in a second, this
/// time counts instead of the second: what is gone does not drift.
double energy_drift(const ProbeQuestion& question, const ProbeResult& result);

/// Substeps beyond which a substep moves a typical ball by less than floats can tell with the error allowed:
/// dt < ulp(distance) / (2 restitution v). 0 where positions are compensated.
std::uint32_t float_floor(const BudgetQuestion& question);

class BudgetChooser {
public:
    /// `backend` belongs to the chooser until it is done, and outlives it. Nothing runs yet.
    BudgetChooser(Backend& backend, const BudgetQuestion& question);

    /// Runs up to so many substeps of a probe; never waits. True once the choice is there. Throws what Backend::load
    /// throws.
    bool advance(std::uint32_t substeps);
    bool done() const { return done_; }
    const BudgetChoice& choice() const { return choice_; }
    std::uint32_t substeps_run() const { return ran_; }

private:
    ProbeQuestion with(std::uint32_t substeps) const;
    bool can_be_probed(std::uint32_t substeps) const;
    Rung& rung(std::uint32_t substeps);
    void take(Rung& rung, const ProbeResult& result) const;
    std::optional<bool> passes(std::uint32_t substeps);
    std::optional<std::uint32_t> next_to_probe();
    std::optional<std::uint32_t> best_of(std::span<const std::uint32_t> counts);
    void finish(std::uint32_t substeps, bool met);
    std::optional<Demand> binding(std::uint32_t substeps);

    Backend& backend_;
    BudgetQuestion question_;
    std::vector<std::uint32_t> ladder_;
    std::size_t start_ = 0;  // in the ladder: the first guess
    std::map<std::uint32_t, Rung> rungs_;
    std::uint32_t wanted_ = 0;  // to be probed before it can go on
    std::optional<CollisionProbe> probe_;
    double softness_ = 0.0;
    std::uint32_t ran_ = 0;
    bool done_ = false;
    BudgetChoice choice_;
};

/// The choice at once; waits for the device.
BudgetChoice choose_substeps(Backend& backend, const BudgetQuestion& question);

}  // namespace ballpit::measure
