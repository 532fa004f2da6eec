// `ballpit bench`: milliseconds per stage and substep, by ball count, state, substeps and sort.
#include <algorithm>
#include <iostream>
#include <map>
#include <memory>

#include "app/bench_limits.h"
#include "app/bench_report.h"
#include "app/bench_run.h"
#include "app/budget.h"
#include "app/commands.h"
#include "app/report.h"
#include "app/settle.h"
#include "app/setup.h"
#include "core/error.h"

namespace ballpit::app {

namespace {

// What was asked for, else what the scene has.
std::vector<std::uint32_t> counts(const Options& options, const Settings& base) {
    return options.balls.empty() ? std::vector{base.balls} : options.balls;
}

// Every combination for one count.
std::vector<Settings> combinations(const Options& options, const Settings& base) {
    std::vector<Settings> all;
    const auto substeps = options.substeps.empty() ? std::vector{base.substeps} : options.substeps;
    const auto sorts = options.sort.empty() ? std::vector{setting_text(*find_setting("sort"), base)} : options.sort;
    for (const std::uint32_t n : substeps) {
        for (const std::string& sort : sorts) {
            Settings settings = base;
            assign_setting(settings, "substeps", std::to_string(n));
            assign_setting(settings, "sort", sort);
            all.push_back(settings);
        }
    }
    return all;
}

// The same state gives the same bits, whatever sorted it.
bool sorts_agree(const std::vector<BenchRow>& rows) {
    std::map<std::tuple<std::string, std::uint32_t, std::uint32_t, std::uint64_t>, std::uint64_t> hashes;
    return std::ranges::all_of(rows, [&hashes](const BenchRow& row) {
        return hashes.try_emplace({row.state, row.balls, row.substeps, row.steps}, row.hash).first->second == row.hash;
    });
}

class BenchCommand {
public:
    explicit BenchCommand(const Options& options)
        : options_(options),
          setup_(make_setup(options)),
          json_(options.json),
          csv_(options.csv),
          quiet_(options.json == "-" || options.csv == "-"),
          device_(open_device(options.backend, setup_.paths.shaders, !options.draw.empty())),
          origin_(report_origin(*device_.backend, command_text(options))) {
        for (const std::uint32_t count : counts(options_, setup_.settings)) {  // a mistake is told before the work
            assign_setting(setup_.settings, "balls", std::to_string(count));
            combinations(options_, setup_.settings);
        }
        if (setup_.settings.dt == 0.0) {
            throw InputError("--set dt=0: expected a step of some length, or nothing runs that could be timed");
        }
        if (!device_.note.empty()) {
            std::cerr << "ballpit: " << device_.note << "\n";
        }
        plan_.steps = options.steps.value_or(20);
        plan_.limit_s = options.limit;
        plan_.dispatches = options.dispatches;
        if (!options.draw.empty()) {
            picture_ = std::make_unique<BenchPicture>(
                setup_.paths, options.draw == "impostor" ? view::Look::impostor : view::Look::model, options.width,
                options.height);
            plan_.picture = picture_.get();
        }
    }

    int run() {
        const auto preset = parse_budget(options_.budget);
        limits_ = measure_limits(*device_.backend, setup_.paths.shaders);
        const auto wanted = counts(options_, setup_.settings);
        setup_.settings.balls = wanted.front();
        Simulation simulation = make_simulation(setup_, device_);
        if (!quiet_) {
            std::cout << setup_.scene.name << " on " << simulation.backend().device() << ", "
                      << simulation.backend().driver() << "; medians of up to " << plan_.steps
                      << " steps, ms; %: of the rate of a copy\n";
            print_limits(std::cout, limits_);
            print_bench_header(std::cout);
        }
        // A row that the device has no room for does not take the others with it.
        try {
            for (const std::uint32_t balls : wanted) {
                setup_.settings.balls = balls;
                for (const std::string& state : options_.state) {
                    measure_state(simulation, state, preset);
                }
            }
        } catch (const DeviceError&) {
            finish();
            throw;
        }
        return finish();
    }

private:
    void measure_state(Simulation& simulation, const std::string& state,
                       const std::optional<measure::BudgetPreset>& preset) {
        const bool settled = state == "settled";
        std::optional<Settling> settling;
        simulation.load(settled ? lowered(setup_.scene, setup_.settings.balls) : setup_.scene, setup_.settings,
                        setup_.seed);
        if (settled) {
            settling = settle(simulation, options_.settle);
        }
        const Checkpoint start = simulation.checkpoint();
        for (Settings settings : combinations(options_, setup_.settings)) {
            if (preset) {
                simulation.restore(start);
                simulation.change(settings);
                tell(*preset, apply_budget(*preset, simulation, simulation.backend(), settings));
            }
            rows_.push_back(measure_row(simulation, start, settings, plan_, limits_));
            rows_.back().state = state;
            rows_.back().settling = settling;
            if (!quiet_) {
                print_bench_row(std::cout, rows_.back(), limits_);
            }
        }
    }

    // 1 where something that was measured cannot be true.
    int finish() {
        Json report = origin_.device;
        report.erase("backend");
        report["command"] = origin_.command;
        report["date"] = origin_.date;
        report["limits"] = limits_json(limits_);
        const bool possible = std::ranges::all_of(rows_, &BenchRow::possible);
        const bool agree = sorts_agree(rows_);
        report["possible"] = possible;
        report["sorts_agree"] = agree;
        report["rows"] = Json::array();
        for (const BenchRow& row : rows_) {
            report["rows"].push_back(bench_row_json(row, limits_));
        }
        json_.write(report.dump(2) + "\n");
        csv_.write(bench_csv(rows_, limits_, origin_));
        if (!possible) {
            std::cerr << "ballpit: some of what was measured cannot be true, and is left out of the results\n";
        }
        if (!agree) {
            std::cerr << "ballpit: one sort gave another state than another\n";
        }
        return possible && agree ? 0 : 1;
    }

    const Options& options_;
    Setup setup_;
    Report json_;
    Report csv_;
    bool quiet_;
    Device device_;
    ReportOrigin origin_;
    std::unique_ptr<BenchPicture> picture_;
    BenchPlan plan_;
    measure::DeviceLimits limits_;
    std::vector<BenchRow> rows_;
};

}  // namespace

int run_bench(const Options& options) {
    if (options.steps == 0) {
        throw InputError("--steps 0: expected at least 1 step to time");
    }
    check_budget(options);
    return BenchCommand(options).run();
}

}  // namespace ballpit::app
