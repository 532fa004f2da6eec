// `ballpit bench`: milliseconds per stage, by ball count, substeps and sort.
#include <chrono>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "app/budget.h"
#include "app/commands.h"
#include "app/report.h"
#include "app/setup.h"
#include "core/error.h"
#include "core/stopwatch.h"
#include "measure/statistics.h"

namespace ballpit::app {

namespace {

using measure::median;
using measure::quantile;

struct Row {
    std::string backend;
    std::string scene;
    std::uint32_t balls = 0;
    std::uint32_t substeps = 0;
    std::string sort;
    std::uint32_t grid_reuse = 1;
    std::uint32_t missed = 0;        // ends of contacts that a used grid did not show
    std::vector<double> substep_ms;  // a sample a substep; the mean of a step's where not all of them build a grid
    std::array<std::vector<double>, stage_count> stage_ms;
    double wall_ms = 0.0;  // a substep, on the wall clock, queueing included
};

void run_steps(Simulation& simulation, std::uint64_t steps) {
    for (std::uint64_t i = 0; i < steps; ++i) {
        simulation.step();
    }
    simulation.backend().finish();
}

// The mean of these substeps.
void add_sample(Row& row, std::span<const StageTimes> substeps) {
    double sum = 0.0;
    for (std::size_t stage = 0; stage < stage_count; ++stage) {
        double ms = 0.0;
        for (const StageTimes& times : substeps) {
            ms += times[stage] / static_cast<double>(substeps.size());
        }
        row.stage_ms[stage].push_back(ms);
        sum += ms;
    }
    row.substep_ms.push_back(sum);
}

Row measure_row(Simulation& simulation, std::uint64_t steps) {
    Backend& backend = simulation.backend();
    run_steps(simulation, steps);  // warm-up: compiles, clocks, caches
    backend.set_timing(true);
    const auto start = std::chrono::steady_clock::now();
    run_steps(simulation, steps);
    const double wall_ms = milliseconds_since(start);
    backend.set_timing(false);

    const Settings& settings = simulation.settings();
    Row row;
    row.backend = backend.name();
    row.scene = simulation.scene().name;
    row.balls = settings.balls;
    row.substeps = settings.substeps;
    row.sort = sort_names[static_cast<std::size_t>(settings.sort)];
    row.grid_reuse = settings.grid_reuse;
    row.missed = read_slot<Status>(backend, Slot::status).front().missed;
    row.wall_ms = wall_ms / static_cast<double>(steps * settings.substeps);
    const std::vector<StageTimes> times = backend.take_times();
    const std::size_t together = settings.grid_reuse > 1 ? settings.substeps : 1;
    for (std::size_t first = 0; first + together <= times.size(); first += together) {
        add_sample(row, std::span(times).subspan(first, together));
    }
    return row;
}

Json row_json(const Row& row) {
    Json stages = Json::object();
    Json spread = Json::object();
    for (std::size_t stage = 0; stage < stage_count; ++stage) {
        const std::string name(stage_names[stage]);
        stages[name] = median(row.stage_ms[stage]);
        spread[name] = {quantile(row.stage_ms[stage], 0.25), quantile(row.stage_ms[stage], 0.75)};
    }
    return {{"backend", row.backend},
            {"scene", row.scene},
            {"balls", row.balls},
            {"substeps", row.substeps},
            {"sort", row.sort},
            {"grid_reuse", row.grid_reuse},
            {"missed", row.missed},
            {"ms_per_substep", median(row.substep_ms)},
            {"ms_per_substep_quartiles", {quantile(row.substep_ms, 0.25), quantile(row.substep_ms, 0.75)}},
            {"wall_ms_per_substep", row.wall_ms},
            {"samples", row.substep_ms.size()},
            {"stages", stages},
            {"stages_quartiles", spread}};
}

std::string csv_text(const std::vector<Row>& rows, const Json& device) {
    std::ostringstream out;
    out << "device,driver,backend,scene,balls,substeps,sort,grid_reuse,missed,ms_per_substep,q1,q3,wall_ms_per_substep";
    for (const std::string_view name : stage_names) {
        out << ',' << name;
    }
    out << '\n';
    for (const Row& row : rows) {
        out << device["device"] << ',' << device["driver"] << ',' << row.backend << ",\"" << row.scene << "\","
            << row.balls << ',' << row.substeps << ',' << row.sort << ',' << row.grid_reuse << ',' << row.missed << ','
            << median(row.substep_ms) << ',' << quantile(row.substep_ms, 0.25) << ',' << quantile(row.substep_ms, 0.75)
            << ',' << row.wall_ms;
        for (const auto& stage : row.stage_ms) {
            out << ',' << median(stage);
        }
        out << '\n';
    }
    return out.str();
}

void print_header() {
    std::cout << std::right << std::setw(9) << "balls" << std::setw(10) << "substeps" << std::setw(15) << "sort"
              << std::setw(14) << "ms/substep" << std::setw(20) << "quartiles";
    for (const std::string_view name : stage_names) {
        std::cout << std::setw(14) << name;
    }
    std::cout << "\n";
}

void print(const Row& row) {
    std::ostringstream quartiles;
    quartiles << std::fixed << std::setprecision(4) << quantile(row.substep_ms, 0.25) << ".."
              << quantile(row.substep_ms, 0.75);
    std::cout << std::fixed << std::setprecision(4) << std::setw(9) << row.balls << std::setw(10) << row.substeps
              << std::setw(15) << row.sort << std::setw(14) << median(row.substep_ms) << std::setw(20)
              << quartiles.str();
    for (const auto& stage : row.stage_ms) {
        std::cout << std::setw(14) << median(stage);
    }
    std::cout << std::endl;
}

// Every combination that was asked for; what was not keeps the scene's value.
std::vector<Settings> combinations(const Options& options, const Settings& base) {
    std::vector<Settings> all;
    const auto balls = options.balls.empty() ? std::vector{base.balls} : options.balls;
    const auto substeps = options.substeps.empty() ? std::vector{base.substeps} : options.substeps;
    const auto sorts =
        options.sort.empty() ? std::vector{std::string(sort_names[static_cast<std::size_t>(base.sort)])} : options.sort;
    for (const std::uint32_t count : balls) {
        for (const std::uint32_t n : substeps) {
            for (const std::string& sort : sorts) {
                Settings settings = base;
                assign_setting(settings, "balls", std::to_string(count));
                assign_setting(settings, "substeps", std::to_string(n));
                assign_setting(settings, "sort", sort);
                all.push_back(settings);
            }
        }
    }
    return all;
}

}  // namespace

int run_bench(const Options& options) {
    const std::uint64_t steps = options.steps.value_or(20);
    if (steps == 0) {
        throw InputError("--steps 0: expected at least 1 step to time");
    }
    check_budget(options);
    const auto preset = parse_budget(options.budget);
    const Setup setup = make_setup(options);
    std::vector<Settings> wanted = combinations(options, setup.settings);
    Report json(options.json);
    Report csv(options.csv);
    Device device = open_device(options.backend, setup.paths.shaders, false);
    if (!device.note.empty()) {
        std::cerr << "ballpit: " << device.note << "\n";
    }
    const bool quiet = options.json == "-" || options.csv == "-";
    Simulation simulation = make_simulation(setup, device);
    Json report = device_json(simulation.backend());
    report.erase("backend");
    if (!quiet) {
        std::cout << setup.scene.name << " on " << simulation.backend().device() << ", " << steps
                  << " timed steps a row; medians, ms\n";
        print_header();
    }
    std::vector<Row> rows;
    report["rows"] = Json::array();
    // A row that the device has no room for does not take the others with it.
    const auto finish = [&] {
        json.write(report.dump(2) + "\n");
        csv.write(csv_text(rows, report));
    };
    for (Settings& settings : wanted) {
        try {
            if (preset) {
                simulation.load(setup.scene, settings, setup.seed);
                tell(*preset, apply_budget(*preset, simulation, simulation.backend(), settings));
            }
            simulation.load(setup.scene, settings, setup.seed);
            rows.push_back(measure_row(simulation, steps));
        } catch (const DeviceError&) {
            finish();
            throw;
        }
        report["rows"].push_back(row_json(rows.back()));
        if (!quiet) {
            print(rows.back());
        }
    }
    finish();
    return 0;
}

}  // namespace ballpit::app
