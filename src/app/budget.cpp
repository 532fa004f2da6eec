#include "app/budget.h"

#include <algorithm>
#include <iostream>

#include "app/run_meters.h"
#include "core/error.h"
#include "core/world.h"

namespace ballpit::app {

namespace {

std::string name_of(measure::BudgetPreset preset) {
    return std::string(measure::budget_preset_names[static_cast<std::size_t>(preset)]);
}

std::string name_of(measure::Demand demand) {
    return std::string(measure::demand_names[static_cast<std::size_t>(demand)]);
}

MeterReading reading_now(Simulation& simulation) {
    const bool metering = simulation.metering();
    simulation.set_metering(true);
    RunMeters meters;
    meters.read_now(simulation);
    simulation.set_metering(metering);
    return meters.record().reading;
}

Json rung_json(const measure::Rung& rung) {
    Json json{{"substeps", rung.substeps}, {"meets", rung.meets}};
    if (rung.probed) {
        json["restitution_error"] = rung.restitution;
        json["overlap_error_diameters"] = rung.overlap;
        json["energy_drift_per_s"] = rung.energy;
    }
    Json shares;
    for (std::size_t i = 0; i < measure::demand_count; ++i) {
        const auto demand = static_cast<measure::Demand>(i);
        const bool measured = demand == measure::Demand::restitution || demand == measure::Demand::overlap ||
                              demand == measure::Demand::energy;
        if (rung.probed || !measured) {
            shares[name_of(demand)] = rung.shares[i];
        }
    }
    json["shares_of_budget"] = shares;
    return json;
}

}  // namespace

std::optional<measure::BudgetPreset> parse_budget(const std::string& name) {
    if (name.empty()) {
        return std::nullopt;
    }
    const auto found = std::ranges::find(measure::budget_preset_names, name);
    if (found == measure::budget_preset_names.end()) {
        throw InputError("--budget " + name + ": expected fast, balanced, accurate or historical");
    }
    return static_cast<measure::BudgetPreset>(found - measure::budget_preset_names.begin());
}

void check_budget(const Options& options) {
    const auto counts = [](const std::string& text) { return text.starts_with("substeps="); };
    const auto found = std::ranges::find_if(options.set, counts);
    if (!options.budget.empty() && found != options.set.end()) {
        throw InputError("--budget " + options.budget + " chooses the substeps: leave out --set " + *found);
    }
}

Settings with_choice(Settings settings, const measure::BudgetChoice& choice) {
    settings.substeps = choice.substeps;
    settings.integrator = choice.integrator;
    return settings;
}

measure::BudgetChoice apply_budget(measure::BudgetPreset preset, Simulation& simulation, Backend& probes,
                                   Settings& settings) {
    settings = simulation.settings();
    World world = make_world(simulation.scene(), settings.balls, simulation.seed());
    world.balls.restitutions = simulation.restitutions();
    const measure::ProbeQuestion probe{settings,
                                       measure::probe_scene(world.balls, settings, world.box, variety_of(world.balls))};
    measure::BudgetQuestion question = measure::budget_question(probe, preset);
    question.reading = reading_now(simulation);
    measure::BudgetChoice choice = measure::choose_substeps(probes, question);
    settings = with_choice(settings, choice);
    return choice;
}

void tell(measure::BudgetPreset preset, const measure::BudgetChoice& choice) {
    std::cerr << "ballpit: budget " << name_of(preset) << ": " << choice.sentence << ".\n";
}

Json budget_json(measure::BudgetPreset preset, const measure::BudgetChoice& choice) {
    const measure::ErrorBudget budget = measure::budget_of(preset);
    Json json{{"preset", name_of(preset)},
              {"allowed",
               {{"restitution_error", budget.restitution},
                {"overlap_error_diameters", budget.overlap},
                {"energy_drift_per_s", budget.energy}}},
              {"substeps", choice.substeps},
              {"integrator", integrator_names[static_cast<std::size_t>(choice.integrator)]},
              {"met", choice.met},
              {"binding", choice.binding ? Json(name_of(*choice.binding)) : Json()},
              {"critical_dt_s", choice.critical_dt},
              {"critical_dt_from", choice.network_measured ? "contacts" : "assumption"},
              {"float_floor_substeps", choice.floor == 0 ? Json() : Json(choice.floor)},
              {"softness_diameters", choice.softness},
              {"sentence", choice.sentence}};
    json["tried"] = Json::array();
    for (const measure::Rung& rung : choice.tried) {
        json["tried"].push_back(rung_json(rung));
    }
    return json;
}

}  // namespace ballpit::app
