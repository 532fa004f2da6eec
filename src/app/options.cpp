#include "app/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <iostream>

#include "core/error.h"

namespace ballpit::app {

namespace {

// CLI11 2.1 reads -1 as the largest unsigned number.
std::string whole_number(const std::string& text) {
    const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
    return digits ? "" : "expected a whole number, found '" + text + "'";
}

void add_scene_options(CLI::App& app, Options& options) {
    app.add_option("--scene", options.scene, "Scene of the gallery by name, or a scene file")->capture_default_str();
    app.add_option("--backend", options.backend,
                   "What computes: auto, gpu, cpu (the mirror) or threads (its bits, sooner)")
        ->check(CLI::IsMember({"auto", "gpu", "cpu", "threads"}))
        ->capture_default_str();
    app.add_option("--set", options.set, "KEY=VALUE: a setting of `ballpit settings`; may be repeated")
        ->take_all()
        ->expected(1);
    app.add_option("--seed", options.seed, "Seed of the random fill, instead of the scene's")->check(whole_number);
}

void add_budget_option(CLI::App& app, Options& options) {
    app.add_option("--budget", options.budget,
                   "Substeps by allowed error: fast, balanced, accurate or historical; measured, and told")
        ->check(CLI::IsMember({"fast", "balanced", "accurate", "historical"}));
}

// The whole of a run in a line: whoever gives it cannot mean another scene as well.
CLI::Option* add_code_option(CLI::App& app, Options& options) {
    CLI::Option* code = app.add_option("--code", options.code, "A share code: the frame that somebody else looked at");
    for (const char* other : {"--scene", "--set", "--seed", "--budget"}) {
        code->excludes(app.get_option(other));
    }
    return code;
}

CLI::Option* add_relax_option(CLI::App& app, Options& options) {
    return app.add_flag(
        "--relax", options.relax,
        "Push balls that overlap apart first, so that what their springs hold does not set them flying");
}

void add_model_option(CLI::App& app, Options& options) {
    app.add_option("--model", options.model, "OBJ file that is drawn for a ball, instead of the one of the assets");
}

// "1280x720"
std::string parse_size(const std::string& text, Options& options) {
    const char* end = text.data() + text.size();
    const auto [x, error] = std::from_chars(text.data(), end, options.width);
    if (error == std::errc{} && x != end && *x == 'x') {
        const auto [stop, second] = std::from_chars(x + 1, end, options.height);
        if (second == std::errc{} && stop == end && options.width > 0 && options.height > 0) {
            return {};
        }
    }
    return "expected WIDTHxHEIGHT such as 1280x720";
}

void add_size_option(CLI::App& app, Options& options, const std::string& about) {
    app.add_option_function<std::string>(
        "--size",
        [&options](const std::string& text) {
            if (const std::string problem = parse_size(text, options); !problem.empty()) {
                throw CLI::ValidationError("--size", problem);
            }
        },
        about);
}

CLI::App* add_headless(CLI::App& app, Options& options) {
    CLI::App* headless = app.add_subcommand("headless", "Simulate without a window, and report");
    add_scene_options(*headless, options);
    add_budget_option(*headless, options);
    add_model_option(*headless, options);
    auto* steps = headless->add_option("--steps", options.steps, "Steps to run (default 600)")->check(whole_number);
    headless->add_option("--seconds", options.seconds, "Simulated seconds to run, instead of --steps")
        ->check(CLI::NonNegativeNumber)
        ->excludes(steps);
    CLI::Option* code = add_code_option(*headless, options);
    code->excludes(steps)->excludes(headless->get_option("--seconds"));
    add_relax_option(*headless, options)->excludes(code);
    headless->add_option("--save", options.save, "Scene file of the final state, which goes on from there");
    headless->add_option("--state-out", options.state_out, "CSV of the final state, one row a ball");
    headless->add_option("--trace", options.trace,
                         "CSV with one row a step: energies, heats, momentum, overlap, contacts");
    headless->add_flag("--meters", options.meters, "Meter every substep: the report then has where the energy went");
    headless->add_option("--screenshot", options.screenshot, "PNG of the final state");
    add_size_option(*headless, options, "Size of the screenshot, such as 1280x720");
    headless->add_option("--look", options.look, "How balls are drawn: model, impostor or simple")
        ->check(CLI::IsMember({"model", "impostor", "simple"}))
        ->capture_default_str();
    headless->add_option("--json", options.json, "Report as JSON to a file, or - for standard output");
    return headless;
}

CLI::App* add_check(CLI::App& app, Options& options) {
    CLI::App* check =
        app.add_subcommand("check", "Every dispatch on the GPU against the mirror; exit code 1 on a difference");
    add_scene_options(*check, options);
    check->add_option("--steps", options.steps, "Steps to check (default 10)")->check(whole_number);
    check->add_option("--json", options.json, "Report as JSON to a file, or - for standard output");
    return check;
}

CLI::App* add_bench(CLI::App& app, Options& options) {
    CLI::App* bench = app.add_subcommand("bench", "Milliseconds per stage");
    add_scene_options(*bench, options);
    bench->add_option("--balls", options.balls, "Ball counts, such as 1000,5000,20000")
        ->delimiter(',')
        ->check(whole_number);
    add_budget_option(*bench, options);
    bench->add_option("--substeps", options.substeps, "Substeps a step, such as 1,8")
        ->excludes(bench->get_option("--budget"))
        ->delimiter(',')
        ->check(whole_number);
    bench->add_option("--sort", options.sort, "Sorts to compare, such as bitonic,bitonic_fused")->delimiter(',');
    bench
        ->add_option("--state", options.state,
                     "States to time: start, as the scene has it, and settled, at rest under gravity")
        ->delimiter(',')
        ->check(CLI::IsMember({"start", "settled"}))
        ->capture_default_str();
    bench->add_option("--settle", options.settle, "Seconds that coming to rest may take")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    bench->add_option("--steps", options.steps, "Timed steps a row, after as many for warm-up (default 20)")
        ->check(whole_number);
    bench->add_option("--limit", options.limit, "Seconds that a row may take: then with fewer steps")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    bench->add_flag("--dispatches", options.dispatches, "Time every dispatch as well, in a run of its own");
    bench
        ->add_option("--draw", options.draw,
                     "Time frames with a picture as well and tell its passes, of balls drawn as model or impostor")
        ->check(CLI::IsMember({"model", "impostor"}));
    add_size_option(*bench, options, "Size of that picture (default 1920x1080)");
    bench->get_option("--scene")->default_str("bench_pile");  // as use_bench_defaults() has it
    bench->add_option("--json", options.json, "Report as JSON to a file, or - for standard output");
    bench->add_option("--csv", options.csv, "Report as CSV to a file, or - for standard output");
    return bench;
}

// What other commands have other defaults for.
void use_bench_defaults(const CLI::App& bench, Options& options) {
    if (bench.count("--scene") == 0) {
        options.scene = "bench_pile";
    }
    if (bench.count("--size") == 0) {
        options.width = 1920;
        options.height = 1080;
    }
}

CLI::App* add_accuracy(CLI::App& app, Options& options) {
    CLI::App* accuracy = app.add_subcommand(
        "accuracy", "What substeps, integrator, precision and reuse of the grid cost, and how exact they are");
    add_scene_options(*accuracy, options);
    accuracy->add_option("--substeps", options.substeps, "Substeps a step, such as 1,2,4,8")
        ->delimiter(',')
        ->check(whole_number);
    accuracy->add_option("--integrator", options.integrator, "Integrators, such as leapfrog,historical")
        ->delimiter(',');
    accuracy->add_option("--precision", options.precision, "float, compensated, or both")
        ->delimiter(',')
        ->check(CLI::IsMember({"float", "compensated"}));
    accuracy
        ->add_option("--grid-reuse", options.grid_reuse,
                     "Substeps that use one grid, such as 1,8; cells are made wide enough for each")
        ->delimiter(',')
        ->check(whole_number);
    accuracy->add_option("--seconds", options.seconds, "Simulated seconds of each run (default 1)");
    accuracy->add_option("--limit", options.limit, "Seconds that one run may take")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    accuracy->add_option("--json", options.json, "Report as JSON to a file, or - for standard output");
    accuracy->add_option("--csv", options.csv, "Report as CSV to a file, or - for standard output");
    return accuracy;
}

CLI::App* add_extremes(CLI::App& app, Options& options) {
    CLI::App* extremes =
        app.add_subcommand("extremes", "What happens at the end of every slider; exit code 1 where it must not");
    extremes->add_option("--backend", options.backend, "What computes: auto, gpu, cpu or reference (double)")
        ->check(CLI::IsMember({"auto", "gpu", "cpu", "reference"}))
        ->capture_default_str();
    extremes->add_option("--only", options.only, "Rows to run, such as E1,E7")->delimiter(',');
    extremes->add_option("--markdown", options.markdown,
                         "Table for the documentation to a file, or - for standard output");
    extremes->add_option("--json", options.json, "Report as JSON to a file, or - for standard output");
    return extremes;
}

CLI::App* add_scenes(CLI::App& app, Options& options) {
    CLI::App* scenes = app.add_subcommand("scenes", "List the scenes");
    auto* ledger = scenes->add_flag("--ledger", options.ledger,
                                    "What a substep of each scene costs in bytes, dispatches and barriers, and what it "
                                    "does without");
    scenes->add_option("--json", options.json, "Ledger as JSON to a file, or - for standard output")->needs(ledger);
    return scenes;
}

}  // namespace

std::optional<Options> parse_options(int argc, const char* const* argv) {
    Options options;
    options.command_line.assign(argv + std::min(argc, 1), argv + argc);
    CLI::App app("Ball Pit: balls collide in a box, every physics stage a compute shader to step through.", "ballpit");
    app.set_version_flag("--version", BALLPIT_VERSION);
    app.require_subcommand(0, 1);
    add_scene_options(app, options);
    add_budget_option(app, options);
    add_model_option(app, options);
    add_relax_option(app, options)->excludes(add_code_option(app, options));
    app.add_flag("--fresh", options.fresh, "The window starts as if for the first time");
    const std::vector<std::pair<CLI::App*, Command>> commands = {
        {add_headless(app, options), Command::headless},
        {add_check(app, options), Command::check},
        {add_bench(app, options), Command::bench},
        {add_accuracy(app, options), Command::accuracy},
        {add_extremes(app, options), Command::extremes},
        {add_scenes(app, options), Command::scenes},
        {app.add_subcommand("settings", "List the settings: unit, range, default"), Command::settings},
    };
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) {  // --help, --version
        app.exit(asked, std::cout, std::cerr);
        return std::nullopt;
    } catch (const CLI::ParseError& error) {
        throw InputError(std::string(error.what()) + "; see `ballpit --help`");
    }
    for (const auto& [subcommand, command] : commands) {
        if (subcommand->parsed()) {
            options.command = command;
        }
    }
    options.scene_given = app.count("--scene") > 0;
    options.backend_given = app.count("--backend") > 0;
    if (options.command == Command::bench) {
        use_bench_defaults(*app.get_subcommand("bench"), options);
    }
    return options;
}

std::string command_text(const Options& options) {
    std::string text = "ballpit";
    for (const std::string& word : options.command_line) {
        text += " " + word;
    }
    return text;
}

}  // namespace ballpit::app
