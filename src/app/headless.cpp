// `ballpit headless`: simulates without a window; state, trace, picture and report on request.
#include <chrono>
#include <cmath>
#include <functional>
#include <iomanip>
#include <iostream>
#include <optional>

#include "app/atomic_file.h"
#include "app/budget.h"
#include "app/commands.h"
#include "app/csv.h"
#include "app/report.h"
#include "app/run_meters.h"
#include "app/screenshot.h"
#include "app/setup.h"
#include "app/shared_run.h"
#include "core/error.h"
#include "core/grid_reuse.h"
#include "core/scene_writer.h"
#include "core/stopwatch.h"
#include "gl/reset.h"
#include "measure/energy.h"
#include "measure/stability.h"
#include "measure/warnings.h"

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
    Trace(const std::string& path, Simulation& simulation, RunMeters& meters)
        : simulation_(simulation), meters_(meters) {
        if (!path.empty()) {
            file_.emplace(path);
            write_trace_header(file_->stream(), simulation.schedule().ball_count);
            add_row();
        }
    }
    void add_row() {
        if (file_) {
            const BallState state = simulation_.synchronised_state();
            meters_.read_now(simulation_);
            const TracedMeters metered{meters_.balance(), meters_.record().reading,
                                       measure::dt_over_critical(meters_.record(), simulation_.settings())};
            write_trace_row(
                file_->stream(), simulation_.step_count(), simulation_.time(),
                measure::totals_of(state, simulation_.settings(), simulation_.features(), simulation_.box()), state,
                metered);
            if (!file_->stream()) {
                file_->commit();  // says so now, and not after hours
            }
        }
    }
    void commit() {
        if (file_) {
            file_->commit();
        }
    }

private:
    Simulation& simulation_;
    RunMeters& meters_;
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

// Where several substeps use one grid: how far balls went meanwhile, and how far they may.
Json grid_json(const Simulation& simulation, const Status& status) {
    const double radius = simulation.largest_ball_radius();
    const double way = drift(status);
    return {{"cell_width_m", simulation.schedule().grid.cell_width},
            {"skin_m", skin(simulation.schedule().grid, radius)},
            {"drift_m", way},
            {"advised_cell_factor", cell_factor_for(way, radius)}};
}

// `warnings`: of the start and the end.
Json make_report(Simulation& simulation, const BallState& state, double wall_ms, const ExtremeNumbers& warnings) {
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
    const Status status = read_slot<Status>(simulation.backend(), Slot::status).front();
    report["status"] = status_json(status, simulation);
    if (simulation.schedule().keeps_places) {
        report["grid"] = grid_json(simulation, status);
    }
    report["extremes"] = extremes_json(measure::worse_of(warnings, counted_extremes(status)));
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
    for (const ExtremeInfo& info : extreme_table()) {
        if (const auto number = report["extremes"][std::string(info.key)].get<double>(); number != 0.0) {
            std::cout << extreme_text(info, number) << "\n";
        }
    }
    if (report["status"]["missed"].is_null()) {
        std::cout << "Contacts may be missed, and without the law diagnostics nobody counts them.\n";
    }
}

// What a share code says of the run, in place of --scene, --set and --seed.
std::optional<SharedCode> apply_code(const Options& options, Setup& setup) {
    if (options.code.empty()) {
        return std::nullopt;
    }
    SharedCode code = decode_share_code(options.code);
    SharedScene shared = shared_scene(code, list_scenes(setup.paths.assets));
    if (!shared.same) {
        std::cerr << "ballpit: the code was made with another scene '" << code.scene << "' than the one here\n";
    }
    setup.scene = std::move(shared.scene);
    setup.settings = shared.settings;
    setup.seed = code.seed;
    return code;
}

// To the moment of the code; what its state hash says of this machine's run.
Json run_code(const SharedCode& code, Simulation& simulation) {
    Stepper stepper(simulation, 0);
    Replay replay(code.changes, code.substep, code.ran);
    while (!replay.advance(stepper, simulation, 1.0)) {
    }
    const auto hash = awaited_hash(stepper, simulation);
    Json report{{"backend", code.backend}, {"device", code.device}};
    report["hash_here"] = hash ? Json(hash_text(*hash)) : Json();
    report["hash"] = code.hash ? Json(hash_text(*code.hash)) : Json();
    report["same"] = hash && code.hash ? Json(*hash == *code.hash) : Json();
    return report;
}

void print_code(const Json& report) {
    std::cout << "the share code's state hash ";
    if (!report["same"].is_boolean()) {
        std::cout << "is not known";
    } else if (report["same"].get<bool>()) {
        std::cout << "agrees: the same bits";
    } else {
        std::cout << "differs: " << report["hash"].get<std::string>() << " there, "
                  << report["hash_here"].get<std::string>() << " here";
    }
    std::cout << "; it was made on " << report["backend"].get<std::string>() << ", "
              << report["device"].get<std::string>() << "\n";
}

ExtremeNumbers warnings_of_start(Simulation& simulation) {
    ExtremeNumbers warnings = measure::warnings_of(simulation, nullptr);
    warnings[Extreme::initial_overlap] = measure::stored_in_overlaps(simulation.raw_state(), simulation.settings(),
                                                                     simulation.features(), simulation.box());
    return warnings;
}

// What the springs hold before and after.
Json relax(Simulation& simulation) {
    const auto elastic = [&] {
        return measure::totals_of(simulation.raw_state(), simulation.settings(), simulation.features(),
                                  simulation.box())
            .elastic;
    };
    Json report{{"elastic_before_J", elastic()}};
    simulation.apply(Relax{});
    report["elastic_after_J"] = elastic();
    return report;
}

// The steps of a run, and what is done after each. Without asking, hours of steps could run on a device that is gone.
void run_steps(Simulation& simulation, std::uint64_t steps, const std::function<void()>& after_step) {
    try {
        for (std::uint64_t i = 0; i < steps; ++i) {
            simulation.step();
            gl::expect_context();
            after_step();
        }
        simulation.backend().finish();
    } catch (const gl::Lost& lost) {
        throw DeviceError(std::string(lost.what()) + "; that was before the end of step " +
                          std::to_string(simulation.step_count()) +
                          ", and no file was written: the same command starts it again");
    }
}

}  // namespace

int run_headless(const Options& options) {
    check_budget(options);
    Setup setup = make_setup(options);
    const std::optional<SharedCode> code = apply_code(options, setup);
    Report json(options.json);
    std::optional<AtomicFile> state_file;
    if (!options.state_out.empty()) {
        state_file.emplace(options.state_out);
    }
    std::optional<AtomicFile> scene_file;
    if (!options.save.empty()) {
        scene_file.emplace(options.save);
    }
    const bool picture = !options.screenshot.empty();
    Device device = open_device(options.backend, setup.paths.shaders, picture);
    if (!device.note.empty()) {
        std::cerr << "ballpit: " << device.note << "\n";
    }
    const auto preset = parse_budget(options.budget);
    Json budget_report;
    Simulation simulation = make_simulation(setup, device);
    if (preset) {
        const measure::BudgetChoice choice = apply_budget(*preset, simulation, simulation.backend(), setup.settings);
        tell(*preset, choice);
        budget_report = budget_json(*preset, choice);
        simulation.load(setup.scene, setup.settings, setup.seed);
    }
    const std::uint64_t steps = code ? 0 : steps_to_run(options, setup.settings.dt);
    std::optional<Screenshot> screenshot;
    if (picture) {
        screenshot.emplace(setup.paths, options);  // before the work: a missing model is told at once
    }

    ExtremeNumbers warnings = warnings_of_start(simulation);
    const Json relaxed = options.relax ? relax(simulation) : Json();
    const bool metered = options.meters || !options.trace.empty();
    simulation.set_metering(metered);
    RunMeters meters;
    Trace trace(options.trace, simulation, meters);
    const auto start = std::chrono::steady_clock::now();
    Json code_report;
    if (code) {
        code_report = run_code(*code, simulation);
    }
    run_steps(simulation, steps, [&] {
        if (metered) {
            meters.take(simulation);
        }
        trace.add_row();
    });
    const double wall_ms = milliseconds_since(start);
    trace.commit();
    simulation.set_metering(true);
    meters.read_now(simulation);
    warnings = measure::worse_of(warnings, measure::warnings_of(simulation, &meters.record()));

    const BallState state = simulation.synchronised_state();
    if (state_file) {
        write_state(state_file->stream(), state);
        state_file->commit();
    }
    if (scene_file) {
        scene_file->stream() << scene_text(scene_of_moment(simulation));
        scene_file->commit();
    }
    if (screenshot) {
        screenshot->save(simulation, code);
    }
    Json report = make_report(simulation, state, wall_ms, warnings);
    report["meters"] = meters_json(meters, simulation, metered);
    if (preset) {
        report["budget"] = budget_report;
    }
    if (options.relax) {
        report["relaxed"] = relaxed;
    }
    if (options.json != "-") {
        print_summary(report);
    }
    if (code) {
        report["code"] = code_report;
        if (options.json != "-") {
            print_code(code_report);
        }
    }
    json.write(report.dump(2) + "\n");
    return 0;
}

}  // namespace ballpit::app
