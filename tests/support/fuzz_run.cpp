#include "support/fuzz_run.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.h"
#include "core/scene_file.h"
#include "core/scene_writer.h"
#include "core/stepper.h"
#include "measure/extreme_trial.h"
#include "measure/stability.h"
#include "support/fuzz_properties.h"
#include "support/fuzz_stages.h"

namespace ballpit::test {

namespace {

std::uint64_t hash_of(Simulation& simulation) { return hash_state(simulation.raw_state()); }

Status status_of(Simulation& simulation) { return read_slot<Status>(simulation.backend(), Slot::status).front(); }

// The same run of a case twice: looked at from all sides, and then as a user has it, with steps back.
class FuzzRun {
public:
    FuzzRun(const FuzzCase& fuzz_case, const FuzzBackends& backends, FuzzTally& tally)
        : case_(fuzz_case), backends_(backends), tally_(tally) {}

    void look();
    void repeat();
    void save_and_go_on();

private:
    Simulation start() const { return {case_.scene, case_.scene.settings, case_.seed, backends_.device()}; }
    void change(Simulation& simulation, std::uint32_t at);
    void substep(Simulation& simulation);
    void watch_energy(Simulation& simulation);
    void go_back(Stepper& stepper, Simulation& simulation, const Back& back, std::uint32_t at);

    const FuzzCase& case_;
    const FuzzBackends& backends_;
    FuzzTally& tally_;
    std::string place_;
    std::vector<std::uint64_t> hashes_;  // before each substep, after its changes; and at the end
    std::vector<bool> refused_;          // of the actions
    std::optional<measure::Totals> first_energy_;
    bool energy_bounded_ = true;
    bool lost_ = false;
};

void FuzzRun::change(Simulation& simulation, std::uint32_t at) {
    for (std::size_t i = 0; i < case_.actions.size(); ++i) {
        const FuzzAction& action = case_.actions[i];
        if (action.at != at) {
            continue;
        }
        const auto wanted = change_of(action, simulation.settings());
        if (!wanted) {
            continue;
        }
        energy_bounded_ = false;
        const std::uint64_t before = hash_of(simulation);
        try {
            simulation.apply(*wanted);
            ++tally_.changes;
        } catch (const InputError&) {
            require("a refusal changes nothing", hashes_differ(before, hash_of(simulation)), place_);
            refused_[i] = true;
            ++tally_.refused;
        }
    }
}

void FuzzRun::watch_energy(Simulation& simulation) {
    const Settings& settings = simulation.settings();
    const bool symplectic =
        settings.integrator == Integrator::leapfrog || settings.integrator == Integrator::velocity_verlet;
    energy_bounded_ = energy_bounded_ && symplectic && !settings.pull && !lost_ && settings.dt > 0.0 &&
                      !settings.laws.shake &&
                      (settings.cell_factor >= 1.0 || settings.neighbours == NeighbourSearch::brute_force);
    if (!energy_bounded_) {
        return;
    }
    const MeterRecord record = measure::metered(simulation);
    const auto gauges = measure::gauges(record, simulation);
    energy_bounded_ =
        record.reading.max_overlap_share < 0.4 && !gauges.empty() &&
        std::ranges::all_of(gauges, [](const measure::Gauge& gauge) { return gauge.light() == measure::Light::green; });
    if (!energy_bounded_) {
        return;
    }
    const measure::Totals totals = measure::totals_of(simulation);
    if (!first_energy_) {
        first_energy_ = totals;
    }
    const dvec3 gravity = settings.laws.gravity ? settings.gravity : dvec3(0.0);
    const double rounding = rounding_of_heights(simulation.raw_state(), gravity) * case_.substeps;
    require("energy does not grow by itself", energy_grew(*first_energy_, totals, rounding), place_);
}

void FuzzRun::substep(Simulation& simulation) {
    SeenSubstep seen;
    seen.before = simulation.raw_state();
    seen.status_before = status_of(simulation);
    seen.params = simulation.params();
    seen.features = simulation.features();
    seen.assigned = std::ranges::any_of(simulation.schedule().dispatches,
                                        [](const Dispatch& dispatch) { return dispatch.stage == Stage::assign_cells; });
    const Settings settings = simulation.settings();
    simulation.begin_substep();
    run_dispatches(simulation, seen.before, backends_, place_);
    simulation.end_substep();
    seen.after = simulation.raw_state();
    seen.status_after = status_of(simulation);
    require("no ball is exchanged", balls_exchanged(seen), place_);
    require("nothing is lost in silence", lost_in_silence(seen), place_);
    require("nothing is lost without cause", lost_without_cause(seen), place_);
    require("nothing is outside in silence", outside_in_silence(seen), place_);
    require("the count is the one that was asked for",
            seen.after.count() == settings.balls ? Complaint() : Complaint("it is not"), place_);
    lost_ = lost_ || seen.status_after.not_finite != 0;
    ++tally_.substeps;
}

void FuzzRun::look() {
    Simulation simulation = start();
    refused_.assign(case_.actions.size(), false);
    place_ = "at the start";
    watch_energy(simulation);
    for (std::uint32_t s = 0; s < case_.substeps; ++s) {
        place_ = "substep " + std::to_string(s);
        change(simulation, s);
        hashes_.push_back(hash_of(simulation));
        substep(simulation);
        watch_energy(simulation);
    }
    hashes_.push_back(hash_of(simulation));
    ++tally_.cases;
    tally_.energies += energy_bounded_ ? 1 : 0;
    tally_.quarantined += lost_ ? 1 : 0;
}

void FuzzRun::go_back(Stepper& stepper, Simulation& simulation, const Back& back, std::uint32_t at) {
    const Position here = stepper.position();
    for (std::uint32_t i = 0; i < back.count; ++i) {
        stepper.back(static_cast<StepUnit>(back.unit));
    }
    stepper.go_to(here);
    require("back and forth again is the same", hashes_differ(hashes_[at], hash_of(simulation)), place_);
    ++tally_.stepped_back;
}

void FuzzRun::repeat() {
    Simulation simulation = start();
    Stepper stepper(simulation, std::size_t{1} << 20);
    for (std::uint32_t s = 0; s < case_.substeps; ++s) {
        place_ = "substep " + std::to_string(s) + ", second run";
        for (std::size_t i = 0; i < case_.actions.size(); ++i) {
            const auto wanted = change_of(case_.actions[i], simulation.settings());
            if (case_.actions[i].at == s && wanted && !refused_[i]) {
                stepper.change(*wanted);
            }
        }
        require("a second run is the same", hashes_differ(hashes_[s], hash_of(simulation)), place_);
        for (const FuzzAction& action : case_.actions) {
            const auto back = back_of(action);
            if (action.at == s && back) {
                go_back(stepper, simulation, *back, s);
            }
        }
        stepper.forward(StepUnit::substep);
    }
    place_ = "the end of the second run";
    require("a second run is the same", hashes_differ(hashes_.back(), hash_of(simulation)), place_);
    go_back(stepper, simulation, {static_cast<std::uint8_t>(StepUnit::substep), 3}, case_.substeps);
    simulation.backend().finish();
    stepper.update();
    require("a replay arrives", stepper.divergence() ? Complaint("it diverges") : Complaint(), place_);
}

// Saved in the middle and loaded again, if nothing is done to it later.
void FuzzRun::save_and_go_on() {
    const std::uint32_t middle = case_.substeps / 2;
    if (!case_.actions.empty() || lost_) {
        return;
    }
    place_ = "saved at substep " + std::to_string(middle);
    Simulation simulation = start();
    const auto run_on = [](Simulation& s, std::uint32_t substeps) {
        for (std::uint32_t i = 0; i < substeps; ++i) {
            s.substep();
        }
    };
    run_on(simulation, middle);
    if (!simulation.builds_grid()) {
        return;  // a saved moment builds its own, whose order may differ
    }
    std::string text;
    try {
        text = scene_text(scene_of_moment(simulation));
    } catch (const InputError&) {
        ++tally_.refused;  // a number that no file can hold
        return;
    }
    const Scene moment = parse_scene(text, "moment.json");
    Simulation resumed(moment, moment.settings, case_.seed, backends_.device());
    require("a saved moment is the moment", hashes_differ(hashes_[middle], hash_of(resumed)), place_);
    run_on(resumed, case_.substeps - middle);
    require("a saved moment goes on", hashes_differ(hashes_.back(), hash_of(resumed)), place_);
}

}  // namespace

std::optional<FuzzFailure> run_fuzz_case(const FuzzCase& fuzz_case, const FuzzBackends& backends, FuzzTally& tally) {
    try {
        const std::string text = case_text(fuzz_case);
        const FuzzCase read = parse_case(text, "case.json");  // as whoever opens the saved file has it
        if (case_text(read) != text) {
            return FuzzFailure{"a scene file is read as it was written", "it is not"};
        }
        FuzzRun run(read, backends, tally);
        run.look();
        run.repeat();
        run.save_and_go_on();
        require("the driver has nothing to complain of", backends.driver ? backends.driver() : Complaint(),
                "all of it");
    } catch (const Stop& stop) {
        return stop.failure;
    } catch (const DeviceError&) {  // no room: told, and nothing of the physics
    } catch (const std::exception& error) {
        return FuzzFailure{"nothing is thrown", error.what()};
    }
    return std::nullopt;
}

}  // namespace ballpit::test
