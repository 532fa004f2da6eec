// `ballpit accuracy`: what each choice costs and how exact it is; Ctrl+C keeps what is there.
#include <cmath>
#include <csignal>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <utility>

#include "app/accuracy_report.h"
#include "app/commands.h"
#include "app/progress_line.h"
#include "app/setup.h"
#include "core/error.h"
#include "core/text.h"
#include "cpu/cpu_backend.h"
#include "gpu/gpu_backend.h"
#include "gpu/programs.h"
#include "measure/pareto.h"
#include "measure/sweep_points.h"

namespace ballpit::app {

namespace {

using measure::Sweep;
using measure::SweepMetric;
using measure::SweepRow;

volatile std::sig_atomic_t interrupted = 0;
void interrupt(int) { interrupted = 1; }

constexpr double slice_ms = 500.0;  // between two looks at the keyboard's Ctrl+C

std::uint32_t in_range(std::string_view key, std::uint32_t value, double minimum, double maximum) {
    if (value < minimum || value > maximum) {
        throw InputError("--" + std::string(key) + " " + std::to_string(value) + ": expected " +
                         range_text(minimum, maximum, "", "a whole number"));
    }
    return value;
}

measure::SweepLists lists_of(const Options& options) {
    measure::SweepLists lists;
    for (const std::string& name : options.integrator) {
        Settings settings;
        assign_setting(settings, "integrator", name);
        lists.integrators.push_back(settings.integrator);
    }
    if (!std::isfinite(options.limit) || !std::isfinite(options.seconds.value_or(1.0)) ||
        options.seconds.value_or(1.0) <= 0.0) {
        throw InputError("--seconds and --limit: expected numbers of seconds above 0");
    }
    constexpr double most_substeps = 1 << 20;
    for (const std::uint32_t n : options.substeps) {
        lists.substeps.push_back(in_range("substeps", n, 1, most_substeps));
    }
    for (const std::string& precision : options.precision) {
        lists.compensated.push_back(precision == "compensated");
    }
    const SettingInfo& reuse = *find_setting("grid_reuse");
    for (const std::uint32_t m : options.grid_reuse) {
        lists.grid_reuse.push_back(in_range("grid-reuse", m, reuse.minimum, reuse.maximum));
    }
    return lists;
}

// All backends of the sweep share the programs, so that nothing is compiled twice.
measure::SweepBackends backends_of(const Backend& device, const Paths& paths) {
    measure::SweepBackends backends;
    backends.reference = [] { return std::make_unique<cpu::CpuBackend<double>>(); };
    if (device.name() == "gpu") {
        auto programs = std::make_shared<gpu::Programs>(paths.shaders);
        backends.device = [programs] { return std::make_unique<gpu::GpuBackend>(programs); };
    } else {
        backends.device = [name = std::string(device.name())] { return make_cpu_backend(name); };
    }
    return backends;
}

void print_header(const Sweep& sweep, std::ostream& out) {
    const measure::Reference& reference = sweep.reference();
    if (reference.usable()) {
        const double dt = sweep.question().settings.dt;
        out << "Reference in double: " << reference.substeps << " substeps a step; positions mean something for "
            << static_cast<double>(*reference.steps) * dt << " s of " << static_cast<double>(sweep.steps()) * dt
            << " s.\n";
    } else {
        out << reference.note << "\n";
    }
    out << std::right << std::setw(17) << "integrator" << std::setw(9) << "substeps" << std::setw(12) << "precision"
        << std::setw(6) << "reuse" << std::setw(9) << "Nc" << std::setw(12) << "ms/sim. s" << std::setw(13)
        << "position m" << std::setw(12) << "energy 1/s" << std::setw(10) << "overlap" << std::setw(13) << "restitution"
        << "\n";
}

std::string cell_text(const std::optional<double>& value, int digits = 3) {
    std::ostringstream out;
    if (value) {
        out << std::setprecision(digits) << *value;
    } else {
        out << "-";
    }
    return out.str();
}

std::string missed_text(const SweepRow& row) {
    return row.missed && *row.missed > 0 ? "  " + std::to_string(*row.missed) + " contacts missed" : "";
}

void print_row(const SweepRow& row, std::ostream& out) {
    out << std::right << std::setw(17) << integrator_names.at(static_cast<std::size_t>(row.point.integrator))
        << std::setw(9) << row.point.substeps << std::setw(12) << (row.point.compensated ? "compensated" : "float")
        << std::setw(6) << row.point.grid_reuse << std::setw(9) << cell_text(row.substeps_a_contact) << std::setw(12)
        << cell_text(row.ms_a_second, 4) << std::setw(13) << cell_text(row.position) << std::setw(12)
        << cell_text(row.energy) << std::setw(10) << cell_text(row.overlap) << std::setw(13)
        << cell_text(row.restitution) << missed_text(row) << (row.note.empty() ? "" : "  " + row.note) << std::endl;
}

void run_sweep(Sweep& sweep, bool quiet) {
    const ProgressLine progress;
    std::size_t printed = 0;
    bool headed = false;
    bool more = !sweep.done();
    while (more && interrupted == 0) {
        more = sweep.advance(slice_ms);
        for (; printed < sweep.rows().size() && !quiet; ++printed) {
            progress.clear();
            if (!std::exchange(headed, true)) {
                print_header(sweep, std::cout);
            }
            print_row(sweep.rows()[printed], std::cout);
        }
        progress.show(sweep.progress(), sweep.seconds_left());
    }
    progress.clear();
}

void print_front(const Sweep& sweep, SweepMetric metric, std::ostream& out) {
    std::vector<measure::Trade> trades;
    for (const SweepRow& row : sweep.rows()) {
        trades.push_back({row.ms_a_second, measure::metric_of(row, metric)});
    }
    const auto front = measure::pareto_front(trades);
    if (front.empty()) {
        return;
    }
    out << "\nNothing beats (" << measure::sweep_metric_names.at(static_cast<std::size_t>(metric)) << "):\n";
    for (const std::size_t i : front) {
        print_row(sweep.rows()[i], out);
    }
}

}  // namespace

int run_accuracy(const Options& options) {
    const measure::SweepLists lists = lists_of(options);
    const Setup setup = make_setup(options);
    Report json(options.json);
    Report csv(options.csv);
    Device device = open_device(options.backend, setup.paths.shaders, false);
    const bool quiet = options.json == "-" || options.csv == "-";
    if (!device.note.empty()) {
        std::cerr << "ballpit: " << device.note << "\n";
    }
    if (!quiet) {
        std::cout << setup.scene.name << " on " << device.backend->device() << "\n";
    }
    const measure::SweepBackends backends = backends_of(*device.backend, setup.paths);
    Sweep sweep({setup.scene, setup.settings, setup.seed, sweep_points(setup.settings, lists),
                 options.seconds.value_or(1.0), options.limit},
                backends);
    std::signal(SIGINT, interrupt);
    run_sweep(sweep, quiet);
    if (interrupted != 0) {
        std::cerr << "ballpit: stopped; " << sweep.rows().size() << " of " << sweep.question().points.size()
                  << " choices were measured\n";
    } else if (sweep.rows().empty()) {
        std::cerr << "ballpit: " << sweep.reference().note << "\n";
    }
    std::vector<measure::CollisionRung> collisions;
    if (interrupted == 0) {
        collisions = measure::collision_ladder({setup.settings, sweep.probe_scene()}, backends.device);
    }
    const ReportOrigin origin = report_origin(*device.backend, command_text(options));
    json.write(accuracy_json(sweep, collisions, origin).dump(2) + "\n");
    csv.write(accuracy_csv(sweep, origin));
    if (!quiet) {
        for (std::size_t metric = 0; metric < measure::sweep_metric_names.size(); ++metric) {
            print_front(sweep, static_cast<SweepMetric>(metric), std::cout);
        }
    }
    return 0;
}

}  // namespace ballpit::app
