// Finds the cheapest count of substeps that meets an error budget, by probes of ever other counts.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "measure/budget_words.h"
#include "measure/error_budget.h"

namespace ballpit::measure {

namespace {

constexpr std::array<std::uint32_t, 20> ladder = {1,  2,  3,  4,   6,   8,   12,  16,  24,  32,
                                                  48, 64, 96, 128, 192, 256, 384, 512, 768, 1024};
constexpr double stable_share = 0.9;       // of the critical substep
constexpr double least_resolution = 6.0;   // substeps a contact
constexpr double most_of_diameter = 0.25;  // that a ball may move in a substep
constexpr std::uint32_t historical_substeps = 8;

double substep_dt(const Settings& settings) { return settings.dt / settings.substeps; }

// Of the contact that is over first.
double contact_frequency(const ProbeQuestion& question) {
    return contact_frequency(question, !question.settings.laws.contact);
}

// These two add energy to every contact: no count of theirs is cheaper than one of leapfrog, whose substep costs the
// same.
Integrator integrator_for(const BudgetQuestion& question) {
    const Integrator now = question.probe.settings.integrator;
    if (question.historical) {
        return Integrator::historical;
    }
    return now == Integrator::forward_euler || now == Integrator::historical ? Integrator::leapfrog : now;
}

double first_guess(const BudgetQuestion& question) {
    const ProbeQuestion& probe = question.probe;
    const double step = probe.settings.dt;
    const double zeta = damping_ratio(probe);
    const double allowed = question.budget.restitution;
    const double resolution = std::max({least_resolution, std::cbrt(2.0 / allowed),
                                        2.0 * std::numbers::pi * zeta * probe.scene.restitution / allowed});
    return std::max({step / (stable_share * critical_dt(question)),
                     step * contact_frequency(probe) / std::numbers::pi * resolution,
                     step * probe.scene.largest_speed / (most_of_diameter * 2.0 * probe.scene.radius)});
}

double& share(Rung& rung, Demand demand) { return rung.shares[static_cast<std::size_t>(demand)]; }

double worst(const Rung& rung) { return *std::ranges::max_element(rung.shares); }

}  // namespace

BudgetChooser::BudgetChooser(Backend& backend, const BudgetQuestion& question)
    : backend_(backend), question_(question) {
    choice_.integrator = integrator_for(question_);
    choice_.substeps = question_.probe.settings.substeps;
    if (const std::string nothing = make_probe_collisions(with(1)).nothing; !nothing.empty()) {
        choice_.nothing = true;
        choice_.met = true;
        choice_.sentence = nothing_sentence(nothing, choice_);
        done_ = true;
        return;
    }
    choice_.floor = float_floor(question_);
    choice_.critical_dt = critical_dt(question_);
    choice_.network_measured = measures_network(question_);
    if (question_.historical) {
        ladder_ = {historical_substeps};
        return;
    }
    for (const std::uint32_t count : ladder) {
        if (ladder_.empty() || ((choice_.floor == 0 || count <= choice_.floor) && can_be_probed(count))) {
            ladder_.push_back(count);
        }
    }
    const auto guess = std::ranges::lower_bound(ladder_, first_guess(question_));
    start_ = std::min<std::size_t>(static_cast<std::size_t>(guess - ladder_.begin()), ladder_.size() - 1);
}

ProbeQuestion BudgetChooser::with(std::uint32_t substeps) const {
    ProbeQuestion question = question_.probe;
    question.settings.substeps = substeps;
    question.settings.integrator = choice_.integrator;
    return question;
}

bool BudgetChooser::can_be_probed(std::uint32_t substeps) const {
    return make_probe_collisions(with(substeps)).nothing.empty();
}

// With what follows from the count alone.
Rung& BudgetChooser::rung(std::uint32_t substeps) {
    const auto [found, fresh] = rungs_.try_emplace(substeps);
    Rung& rung = found->second;
    if (fresh) {
        const ProbeQuestion question = with(substeps);
        const double dt = substep_dt(question.settings);
        rung.substeps = substeps;
        share(rung, Demand::stability) = dt / (stable_share * choice_.critical_dt);
        share(rung, Demand::resolution) = least_resolution * contact_frequency(question) * dt / std::numbers::pi;
        share(rung, Demand::sampling) =
            question.scene.largest_speed * dt / (most_of_diameter * 2.0 * question.scene.radius);
    }
    return rung;
}

void BudgetChooser::take(Rung& rung, const ProbeResult& result) const {
    rung.probed = true;
    rung.restitution = result.restitution_error();
    rung.overlap = result.overlap_error();
    rung.energy = energy_drift(question_.probe, result);
    share(rung, Demand::restitution) = rung.restitution / question_.budget.restitution;
    share(rung, Demand::overlap) = rung.overlap / question_.budget.overlap;
    share(rung, Demand::energy) = rung.energy / question_.budget.energy;
    rung.meets = worst(rung) <= 1.0;
}

// Nothing while a probe has to tell: that of `wanted_` substeps.
std::optional<bool> BudgetChooser::passes(std::uint32_t substeps) {
    const Rung& first = rung(substeps);
    if (worst(first) > 1.0) {
        return false;
    }
    if (!first.probed) {
        wanted_ = substeps;
        return std::nullopt;
    }
    // Below the floor twice as many would only measure rounding; a contact too long to be run has no lucky phase.
    if (!first.meets || (choice_.floor != 0 && 2 * substeps > choice_.floor) || !can_be_probed(2 * substeps)) {
        return first.meets;
    }
    const Rung& twice = rung(2 * substeps);
    if (!twice.probed) {
        wanted_ = 2 * substeps;
        return std::nullopt;
    }
    return twice.meets;
}

std::optional<std::uint32_t> BudgetChooser::next_to_probe() {
    std::size_t i = start_;
    const auto first = passes(ladder_[i]);
    if (!first) {
        return wanted_;
    }
    if (!*first) {
        while (++i < ladder_.size()) {
            const auto more = passes(ladder_[i]);
            if (!more) {
                return wanted_;
            }
            if (*more) {
                finish(ladder_[i], true);
                return std::nullopt;
            }
        }
        return best_of(ladder_);
    }
    for (; i > 0; --i) {
        const auto fewer = passes(ladder_[i - 1]);
        if (!fewer) {
            return wanted_;
        }
        if (!*fewer) {
            break;
        }
    }
    finish(ladder_[i], true);
    return std::nullopt;
}

// No count meets the budget: the one that misses it least, of those that were probed.
std::optional<std::uint32_t> BudgetChooser::best_of(std::span<const std::uint32_t> counts) {
    if (!rung(counts.back()).probed) {
        return counts.back();
    }
    const auto miss = [this](std::uint32_t count) {
        const Rung& of = rung(count);
        return of.probed ? worst(of) : std::numeric_limits<double>::infinity();
    };
    finish(*std::ranges::min_element(counts, {}, miss), false);
    return std::nullopt;
}

// What the next cheaper count would violate most, by itself or at twice the count; of a count that meets nothing, what
// it violates itself.
std::optional<Demand> BudgetChooser::binding(std::uint32_t substeps) {
    const Rung* refused = &rung(substeps);
    if (choice_.met) {
        const auto place = std::ranges::find(ladder_, substeps);
        if (place == ladder_.begin()) {
            return std::nullopt;
        }
        refused = &rung(*(place - 1));
        if (worst(*refused) <= 1.0) {
            refused = &rung(2 * *(place - 1));
        }
    }
    const auto most = std::ranges::max_element(refused->shares);
    return static_cast<Demand>(most - refused->shares.begin());
}

void BudgetChooser::finish(std::uint32_t substeps, bool met) {
    choice_.substeps = substeps;
    choice_.met = met;
    choice_.binding = binding(substeps);
    choice_.measured = rung(substeps);
    choice_.softness = softness_;
    for (const auto& [count, rung] : rungs_) {
        choice_.tried.push_back(rung);
    }
    choice_.sentence = budget_sentence(question_, choice_);
    done_ = true;
}

bool BudgetChooser::advance(std::uint32_t substeps) {
    if (done_) {
        return true;
    }
    if (!probe_) {
        const auto count = next_to_probe();
        if (!count) {
            return true;
        }
        probe_.emplace(backend_, with(*count));
        wanted_ = *count;
    }
    const std::uint32_t before = probe_->substeps_run();
    const bool there = probe_->advance(substeps);
    ran_ += probe_->substeps_run() - before;
    if (there) {
        softness_ = std::max(softness_, probe_->result().softness());
        take(rung(wanted_), probe_->result());
        probe_.reset();
    }
    return false;
}

BudgetChoice choose_substeps(Backend& backend, const BudgetQuestion& question) {
    BudgetChooser chooser(backend, question);
    while (!chooser.advance(most_probe_substeps)) {
        backend.finish();
    }
    return chooser.choice();
}

}  // namespace ballpit::measure
