// `ballpit extremes`: what happens at the end of every slider on this device, row by row; exit code 1 where a row is
// not as it must be.
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "app/accuracy_report.h"
#include "app/clock.h"
#include "app/commands.h"
#include "app/setup.h"
#include "core/error.h"
#include "cpu/cpu_backend.h"
#include "gpu/gpu_backend.h"
#include "gpu/programs.h"
#include "measure/extreme_trial.h"

namespace ballpit::app {

namespace {

using measure::ExtremeCase;
using measure::ExtremeRow;

// The window's clock is not of the backend, but a frame that takes two seconds is an extreme all the same.
void hitch(measure::ExtremeTrial& trial) {
    Clock clock;
    clock.toggle_run();
    constexpr double dt = 1.0 / 60;
    for (int frame = 0; frame < 60; ++frame) {
        clock.steps_for_frame(dt, dt, 1.0);
    }
    const int steps = clock.steps_for_frame(2.0, dt, 1.0);
    trial.at_most("steps of a frame of 2 s, of 120 due:", steps, 16.0);
    int later = 0;
    for (int frame = 0; frame < 60; ++frame) {
        later += clock.steps_for_frame(dt, dt, 1.0);
    }
    trial.at_most("steps of the second after it", later, 62.0);
    trial.at_least("of the same, no fewer than", later, 58.0);
}

constexpr ExtremeCase hitch_case{"E27", "a frame that takes 2 s",
                                 "the same dt, fewer steps: slow motion, nothing made up for", hitch};

int number_of(std::string_view id) { return std::stoi(std::string(id.substr(1))); }

std::vector<ExtremeCase> all_cases() {
    const auto cases = measure::extreme_cases();
    std::vector<ExtremeCase> all(cases.begin(), cases.end());
    all.push_back(hitch_case);
    std::ranges::sort(all, {}, [](const ExtremeCase& extreme) { return number_of(extreme.id); });
    return all;
}

std::vector<ExtremeCase> wanted_cases(const std::vector<std::string>& only) {
    std::vector<ExtremeCase> all = all_cases();
    for (const std::string& id : only) {
        if (std::ranges::find(all, id, &ExtremeCase::id) == all.end()) {
            throw InputError("--only " + id + ": expected a row from " + std::string(all.front().id) + " to " +
                             std::string(all.back().id) + " that there is");
        }
    }
    std::erase_if(all, [&](const ExtremeCase& extreme) {
        return !only.empty() && std::ranges::find(only, extreme.id) == only.end();
    });
    return all;
}

// The context, and what makes one backend after the other on it: all of them share their programs.
struct Bench {
    Device device;
    measure::MakeBackend make;
};

Bench open_bench(const Options& options, const Paths& paths) {
    Bench bench;
    if (options.backend == "reference") {
        bench.device.backend = std::make_unique<cpu::CpuBackend<double>>();
        bench.make = [] { return std::make_unique<cpu::CpuBackend<double>>(); };
        return bench;
    }
    bench.device = open_device(options.backend, paths.shaders, false);
    if (bench.device.backend->name() == "gpu") {
        auto programs = std::make_shared<gpu::Programs>(paths.shaders);
        bench.make = [programs] { return std::make_unique<gpu::GpuBackend>(programs); };
    } else {
        bench.make = [] { return std::make_unique<cpu::CpuBackend<float>>(); };
    }
    return bench;
}

void print(const ExtremeRow& row, std::ostream& out) {
    out << std::left << std::setw(5) << row.id << (row.passed() ? "PASS  " : "FAIL  ") << row.input << " ("
        << measure::digits(row.seconds) << " s)\n     must:   " << row.right << "\n     found:  " << row.found()
        << "\n";
    if (!row.signs.empty()) {
        out << "     warned: " << row.warned() << "\n";
    }
    out << std::flush;
}

Json row_json(const ExtremeRow& row) {
    Json json{{"id", row.id},           {"input", row.input},      {"must", row.right},       {"passed", row.passed()},
              {"seconds", row.seconds}, {"claims", Json::array()}, {"warned", Json::object()}};
    for (const measure::ExtremeClaim& claim : row.claims) {
        json["claims"].push_back({{"holds", claim.holds}, {"text", claim.text}});
    }
    for (const measure::ExtremeSign& sign : row.signs) {
        json["warned"][sign.key] = sign.number;
    }
    return json;
}

Json table_json(const std::vector<ExtremeRow>& rows, const ReportOrigin& origin) {
    Json json = origin.device;
    json["command"] = origin.command;
    json["date"] = origin.date;
    json["passed"] = std::ranges::all_of(rows, &ExtremeRow::passed);
    json["rows"] = Json::array();
    for (const ExtremeRow& row : rows) {
        json["rows"].push_back(row_json(row));
    }
    return json;
}

std::string table_markdown(const std::vector<ExtremeRow>& rows, const ReportOrigin& origin) {
    std::ostringstream out;
    const auto failed = std::ranges::count_if(rows, [](const ExtremeRow& row) { return !row.passed(); });
    out << "# Extremes on " << origin.device["device"].get<std::string>() << "\nMade by `" << origin.command
        << "`, driver " << origin.device["driver"].get<std::string>() << ", " << origin.date << "; " << rows.size()
        << " rows, " << failed
        << " of them not as they must be.\n\n| | input | must | found | warned |\n| --- | --- | --- | --- | --- |\n";
    for (const ExtremeRow& row : rows) {
        out << "| " << row.id << (row.passed() ? "" : " **FAIL**") << " | " << row.input << " | " << row.right << " | "
            << row.found() << " | " << row.warned() << " |\n";
    }
    return out.str();
}

}  // namespace

int run_extremes(const Options& options) {
    const std::vector<ExtremeCase> cases = wanted_cases(options.only);
    const Paths paths = find_paths();
    Report json(options.json);
    Report markdown(options.markdown);
    const bool quiet = options.json == "-" || options.markdown == "-";
    const Bench bench = open_bench(options, paths);
    if (!bench.device.note.empty()) {
        std::cerr << "ballpit: " << bench.device.note << "\n";
    }
    const ReportOrigin origin = report_origin(*bench.device.backend, command_text(options));
    if (!quiet) {
        std::cout << "Extremes on " << bench.device.backend->device() << ", " << bench.device.backend->driver() << "\n";
    }
    std::vector<ExtremeRow> rows;
    for (const ExtremeCase& extreme : cases) {
        rows.push_back(measure::run_extreme(extreme, bench.make));
        if (!quiet) {
            print(rows.back(), std::cout);
        }
    }
    json.write(table_json(rows, origin).dump(2) + "\n");
    markdown.write(table_markdown(rows, origin));
    const auto failed = std::ranges::count_if(rows, [](const ExtremeRow& row) { return !row.passed(); });
    if (!quiet) {
        std::cout << rows.size() << " rows, " << failed << " of them not as they must be\n";
    }
    return failed == 0 ? 0 : 1;
}

}  // namespace ballpit::app
