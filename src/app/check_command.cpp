// `ballpit check`: every dispatch on the GPU against the mirror.
#include <iomanip>
#include <iostream>

#include "app/commands.h"
#include "app/report.h"
#include "app/setup.h"
#include "core/error.h"
#include "cpu/cpu_backend.h"
#include "measure/check.h"

namespace ballpit::app {

namespace {

Json report_json(const measure::CheckReport& report, const Simulation& simulation) {
    Json json{{"scene", simulation.scene().name}, {"seed", simulation.seed()}};
    json.update(device_json(simulation.backend()));
    json["balls"] = simulation.schedule().ball_count;
    json["steps"] = report.steps;
    json["substeps"] = report.substeps;
    json["dispatches"] = report.dispatches;
    json["passed"] = report.passed();
    json["rows"] = Json::array();
    for (const measure::CheckRow& row : report.rows) {
        json["rows"].push_back({{"stage", std::string(stage_name(row.stage))},
                                {"slot", std::string(slot_name(row.slot))},
                                {"elements", row.elements},
                                {"differing", row.differing},
                                {"beyond_bound", row.beyond_bound},
                                {"max_ulp", row.max_ulp},
                                {"max_error", row.max_error},
                                {"of_bound", row.of_bound},
                                {"first", row.first}});
    }
    json["violation_count"] = report.violation_count;
    json["violations"] = report.violations;
    return json;
}

void print(const measure::CheckReport& report, Simulation& simulation) {
    std::cout << simulation.scene().name << ": " << simulation.schedule().ball_count << " balls, " << report.steps
              << " steps, " << report.dispatches << " dispatches on " << simulation.backend().device()
              << " against the mirror\n"
              << std::left << std::setw(15) << "stage" << std::setw(17) << "writes" << std::right << std::setw(14)
              << "elements" << std::setw(11) << "differ" << std::setw(14) << "beyond bound" << std::setw(12)
              << "max error" << std::setw(10) << "of bound"
              << "\n";
    for (const measure::CheckRow& row : report.rows) {
        std::cout << std::left << std::setw(15) << stage_name(row.stage) << std::setw(17) << slot_name(row.slot)
                  << std::right << std::setw(14) << row.elements << std::setw(11) << row.differing << std::setw(14)
                  << row.beyond_bound << std::setw(12) << std::setprecision(3) << row.max_error << std::setw(9)
                  << std::setprecision(2) << 100.0 * row.of_bound << "%\n";
    }
    for (const measure::CheckRow& row : report.rows) {
        if (!row.first.empty()) {
            std::cout << "first difference in " << slot_name(row.slot) << ": " << row.first << "\n";
        }
    }
    for (const std::string& violation : report.violations) {
        std::cout << "invariant broken: " << violation << "\n";
    }
    if (const std::uint32_t missed = read_slot<Status>(simulation.backend(), Slot::status).front().missed; missed > 0) {
        std::cout << "missed contacts: " << missed << ", with one grid for " << simulation.settings().grid_reuse
                  << " substeps; what one ball of a pair misses breaks the balance of momentum. A larger cell_factor "
                     "helps.\n";
    }
    std::cout << (report.passed() ? "passed\n" : "FAILED\n");
}

}  // namespace

int run_check(const Options& options) {
    constexpr std::uint64_t default_steps = 10;
    if (options.steps == 0u) {
        throw InputError("--steps 0: expected at least 1 step to check");
    }
    if (options.backend == "cpu" || options.backend == "threads") {
        throw InputError("check --backend " + options.backend +
                         ": the mirror would be compared with itself; expected gpu or auto");
    }
    const Setup setup = make_setup(options);
    Report json(options.json);
    Device device = open_device("gpu", setup.paths.shaders, false);  // what auto means here
    Simulation simulation = make_simulation(setup, device);
    cpu::CpuBackend<float> mirror;
    const measure::CheckReport report = measure::check(simulation, mirror, options.steps.value_or(default_steps));
    if (options.json != "-") {
        print(report, simulation);
    }
    json.write(report_json(report, simulation).dump(2) + "\n");
    return report.passed() ? 0 : 1;
}

}  // namespace ballpit::app
