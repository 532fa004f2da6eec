// The command line, parsed. docs: design contract in README.md, `ballpit --help`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ballpit::app {

enum class Command { window, headless, check, bench, accuracy, extremes, scenes, settings };

struct Options {
    Command command = Command::window;

    // What to simulate.
    std::string scene = "rain";
    std::string backend = "auto";  // auto, gpu, cpu
    std::vector<std::string> set;  // KEY=VALUE
    std::string budget;            // preset of the error budget that chooses substeps; empty: none
    std::optional<std::uint64_t> seed;
    bool scene_given = false;  // the two above were on the command line
    bool backend_given = false;
    std::string code;    // a share code, instead of all of these
    bool fresh = false;  // window: nothing of last time
    std::string model;   // OBJ file, empty: the ball of the assets

    // headless, check
    std::optional<std::uint64_t> steps;
    std::optional<double> seconds;  // simulated
    std::string state_out;
    std::string save;  // scene file of the final state
    std::string trace;
    bool meters = false;
    bool relax = false;  // window, too
    std::string screenshot;
    int width = 1280;
    int height = 720;
    std::string look = "model";  // model, impostor

    // bench
    std::vector<std::uint32_t> balls;
    std::vector<std::uint32_t> substeps;
    std::vector<std::string> sort;
    std::vector<std::string> state{"start"};  // start, settled
    double settle = 60.0;                     // s of the wall clock, to come to rest
    bool dispatches = false;
    std::string draw;  // look of the balls in the pictures that are timed as well; empty: none

    // accuracy; substeps are bench's, seconds headless's
    std::vector<std::string> integrator;
    std::vector<std::string> precision;  // float, compensated
    std::vector<std::uint32_t> grid_reuse;
    double limit = 20.0;  // s of the wall clock, of one run; bench's, too

    // extremes; backend may be reference, too
    std::vector<std::string> only;  // rows, such as E7; empty: all
    std::string markdown;

    // scenes
    bool ledger = false;

    std::vector<std::string> command_line;  // as it was given, without the program's name

    // reports; "-" is standard output
    std::string json;
    std::string csv;
};

/// Throws InputError for a command line that cannot be understood. Gives nothing where --help or --version was asked
/// for and has been printed.
std::optional<Options> parse_options(int argc, const char* const* argv);

/// The command line as a report names it: "ballpit check --scene rain".
std::string command_text(const Options& options);

}  // namespace ballpit::app
