#include "measure/error_budget.h"

#include <algorithm>
#include <cmath>

#include "core/contact.h"
#include "measure/float_spacing.h"
#include "measure/stability.h"

namespace ballpit::measure {

namespace {

// rad/s, of the stiffest ball before balls touch.
double assumed_frequency(const ProbeQuestion& question) {
    const double neighbours = question.settings.laws.contact ? 8.0 : 1.0;
    return std::sqrt(neighbours * question.settings.stiffness / question.scene.mass);
}

}  // namespace

double damping_ratio(const ProbeQuestion& question) {
    return damping_ratio_from_restitution(question.scene.restitution, question.settings.limit_force);
}

std::string_view budget_preset_meaning(BudgetPreset preset) {
    switch (preset) {
        case BudgetPreset::fast:
            return "stable, six substeps a contact, errors of 10 %";
        case BudgetPreset::balanced:
            return "errors of 1 %";
        case BudgetPreset::accurate:
            return "errors of 0.1 %, or what floats can give";
        case BudgetPreset::historical:
            break;
    }
    return "what the project that this one started from ran with; promises nothing";
}

ErrorBudget budget_of(BudgetPreset preset) {
    switch (preset) {
        case BudgetPreset::fast:
            return {0.1, 0.1, 0.1};
        case BudgetPreset::accurate:
            return {0.001, 0.001, 0.001};
        case BudgetPreset::balanced:
        case BudgetPreset::historical:
            break;
    }
    return {0.01, 0.01, 0.01};
}

BudgetQuestion budget_question(const ProbeQuestion& probe, BudgetPreset preset) {
    return {probe, budget_of(preset), preset == BudgetPreset::historical, {}, {}};
}

bool measures_network(const BudgetQuestion& question) {
    constexpr double settled = 2.0;  // contacts a ball
    if (!question.reading) {
        return false;
    }
    const MeterReading& reading = *question.reading;
    const double assumed = assumed_frequency(question.probe);
    return reading.max_stiffness > assumed * assumed ||
           (reading.max_stiffness > 0.0 && reading.contacts() >= settled * question.probe.settings.balls);
}

double critical_dt(const BudgetQuestion& question) {
    if (measures_network(question)) {
        return critical_dt(std::sqrt(question.reading->max_stiffness), question.reading->max_damping);
    }
    const ProbeScene& scene = question.probe.scene;
    const Settings& settings = question.probe.settings;
    const double k = settings.stiffness;
    const double frequency = assumed_frequency(question.probe);
    const double reduced = settings.laws.contact ? 0.5 * scene.mass : scene.mass;
    const double c = 2.0 * damping_ratio(question.probe) * std::sqrt(k * reduced);
    return critical_dt(frequency, c * frequency * frequency / k);  // every contact has this c and k
}

double energy_drift(const ProbeQuestion& question, const ProbeResult& result) {
    double drift = 0.0;
    double loss = 0.0;
    for (const ProbeGroup& group : result.groups) {
        if (group.largest) {
            continue;  // few collisions are as fast
        }
        const double rate = group.wall ? question.scene.wall_rate * 2.0 / 3.0 : question.scene.pair_rate / 3.0;
        drift += rate * std::abs(group.gain.mean);
        loss += rate * (1.0 - group.restitution.exact * group.restitution.exact);
    }
    return drift / std::max(1.0, loss);
}

std::uint32_t float_floor(const BudgetQuestion& question) {
    const ProbeQuestion& probe = question.probe;
    if (probe.settings.laws.compensated || probe.scene.typical_speed == 0.0) {
        return 0;
    }
    const double least_dt =
        float_spacing(probe.scene.distance) / (2.0 * question.budget.restitution * probe.scene.typical_speed);
    const double most = std::floor(probe.settings.dt / least_dt);
    return static_cast<std::uint32_t>(std::clamp(most, 1.0, 1e9));
}

}  // namespace ballpit::measure
