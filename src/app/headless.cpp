// `ballpit headless`: simulates without a window; state, trace, picture and report on request.
#include <chrono>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <optional>

#include "app/atomic_file.h"
#include "app/commands.h"
#include "app/csv.h"
#include "app/report.h"
#include "app/screenshot.h"
#include "app/setup.h"
#include "core/error.h"
#include "measure/energy.h"

namespace ballpit::app {

namespace {

std::uint64_t steps_to_run(const Options& options, double dt) {
    constexpr std::uint64_t default_steps = 600;
    if (!options.seconds) {
        return options.steps.value_or(default_steps);
    }
    if (!std::isfinite(*options.seconds) || dt <= 0.0 || *options.seconds / dt > 1e15) {
        throw InputError("--seconds " + std::to_string(*options.seconds) +
                         ": cannot be reached in steps of dt = " + std::to_string(dt) + " s");
    }
    return static_cast<std::uint64_t>(std::llround(*options.seconds / dt));
}

// One row a step; the file appears when the run is done.
class Trace {
public:
    Trace(const std::string& path, Simulation& simulation) : simulation_(simulation) {
        if (!path.empty()) {
            file_.emplace(path);
            write_trace_header(file_->stream(), simulation.schedule().ball_count);
            add_row();
        }
    }
    void add_row() {
        if (file_) {
            const BallState state = simulation_.synchronised_state();
            write_trace_row(
                file_->stream(), simulation_.step_count(), simulation_.time(),
                measure::totals_of(state, simulation_.settings(), simulation_.features(), simulation_.box()), state);
        }
    }
    void commit() {
        if (file_) {
            file_->commit();
        }
    }

private:
    Simulation& simulation_;
    std::optional<AtomicFile> file_;
};

Json totals_json(const measure::Totals& totals) {
    return {{"kinetic_J", totals.kinetic},
            {"potential_J", totals.potential},
            {"elastic_J", totals.elastic},
            {"momentum_kg_m_s", {totals.momentum.x, totals.momentum.y, totals.momentum.z}},
            {"max_overlap_m", totals.max_overlap},
            {"contacts", totals.contacts}};
}

Json make_report(Simulation& simulation, const BallState& state, double wall_ms) {
    const auto steps = static_cast<double>(simulation.step_count());
    Json report{{"scene", simulation.scene().name}, {"seed", simulation.seed()}};
    report.update(device_json(simulation.backend()));
    report["balls"] = state.count();
    report["steps"] = simulation.step_count();
    report["simulated_s"] = simulation.time();
    report["wall_ms_per_step"] = steps > 0.0 ? wall_ms / steps : 0.0;
    report["settings"] = settings_json(simulation);
    report["totals"] =
        totals_json(measure::totals_of(state, simulation.settings(), simulation.features(), simulation.box()));
    report["status"] = status_json(read_slot<Status>(simulation.backend(), Slot::status).front());
    report["overlapping_at_start"] = simulation.overlapping_at_start();
    report["state_hash"] = hash_text(hash_state(simulation.raw_state()));
    return report;
}

void print_summary(const Json& report) {
    std::cout << report["scene"].get<std::string>() << ": " << report["balls"] << " balls, " << report["steps"]
              << " steps, " << std::setprecision(4) << report["simulated_s"].get<double>() << " s simulated, "
              << report["wall_ms_per_step"].get<double>() << " ms a step on " << report["device"].get<std::string>()
              << "\nkinetic energy " << report["totals"]["kinetic_J"].get<double>() << " J, "
              << report["totals"]["contacts"] << " contacts, largest overlap "
              << report["totals"]["max_overlap_m"].get<double>() << " m, state hash "
              << report["state_hash"].get<std::string>() << "\n";
    for (const auto& [name, count] : report["status"].items()) {
        if (count != 0) {
            std::cout << "status: " << name << " " << count << " (summed over all substeps)\n";
        }
    }
}

}  // namespace

int run_headless(const Options& options) {
    const Setup setup = make_setup(options);
    Report json(options.json);
    std::optional<AtomicFile> state_file;
    if (!options.state_out.empty()) {
        state_file.emplace(options.state_out);
    }
    const bool picture = !options.screenshot.empty();
    Device device = open_device(options.backend, setup.paths.shaders, picture);
    if (!device.note.empty()) {
        std::cerr << "ballpit: " << device.note << "\n";
    }
    Simulation simulation = make_simulation(setup, device);
    const std::uint64_t steps = steps_to_run(options, setup.settings.dt);
    std::optional<Screenshot> screenshot;
    if (picture) {
        screenshot.emplace(setup.paths, options);  // before the work: a missing model is told at once
    }

    Trace trace(options.trace, simulation);
    const auto start = std::chrono::steady_clock::now();
    for (std::uint64_t i = 0; i < steps; ++i) {
        simulation.step();
        trace.add_row();
    }
    simulation.backend().finish();
    const double wall_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    trace.commit();

    const BallState state = simulation.synchronised_state();
    if (state_file) {
        write_state(state_file->stream(), state);
        state_file->commit();
    }
    if (screenshot) {
        screenshot->save(simulation);
    }
    const Json report = make_report(simulation, state, wall_ms);
    if (options.json != "-") {
        print_summary(report);
    }
    json.write(report.dump(2) + "\n");
    return 0;
}

}  // namespace ballpit::app
