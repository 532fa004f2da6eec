// Runs scenes at random, extremes included, and asks of each what must hold of any (support/fuzz_properties.h). A case
// is a pure function of seed and number. What fails is made small, saved as a scene file, and can be run again.
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>

#include "core/error.h"
#include "cpu/cpu_backend.h"
#include "support/fuzz_run.h"
#include "support/fuzz_shrink.h"
#ifdef BALLPIT_FUZZ_GPU
#include "gl/context.h"
#include "gl/debug.h"
#include "support/gpu_backend.h"
#endif

using namespace ballpit;
using test::FuzzBackends;
using test::FuzzCase;
using test::FuzzFailure;
using test::FuzzTally;

namespace {

constexpr int exit_skipped = 77;

constexpr const char* usage =
    "ballpit_property_fuzz [--backend cpu|gpu] [--cases N] [--seconds S] [--seed S] [--first N] [--out FOLDER]\n"
    "                      [--failures N] [--tries N] [--replay FILE] [--verbose]\n"
    "runs cases from number N on until one of both limits, or until N have failed (5); what fails is made small, by\n"
    "at most N tries (3000), and saved in FOLDER;\n"
    "--replay runs such a file; with --backend gpu every dispatch is compared with the mirror as well\n";

struct Arguments {
    std::string backend = "cpu";
    std::uint64_t cases = ~std::uint64_t{0};
    double seconds = 10.0;
    std::uint64_t seed = 1;
    std::uint64_t first = 0;
    int failures = 5;
    int tries = 3000;
    std::filesystem::path out = ".";
    std::string replay;
    bool verbose = false;
};

[[noreturn]] void refuse() {
    std::cerr << usage;
    std::exit(2);
}

Arguments parse(int count, char** values) {
    Arguments arguments;
    for (int i = 1; i < count; ++i) {
        const std::string option = values[i];
        if (option == "--verbose") {
            arguments.verbose = true;
            continue;
        }
        const std::string value = i + 1 < count ? values[++i] : (refuse(), "");
        if (option == "--backend" && (value == "cpu" || value == "gpu")) {
            arguments.backend = value;
        } else if (option == "--cases") {
            arguments.cases = std::strtoull(value.c_str(), nullptr, 10);
        } else if (option == "--seconds") {
            arguments.seconds = std::strtod(value.c_str(), nullptr);
        } else if (option == "--seed") {
            arguments.seed = std::strtoull(value.c_str(), nullptr, 10);
        } else if (option == "--first") {
            arguments.first = std::strtoull(value.c_str(), nullptr, 10);
        } else if (option == "--failures") {
            arguments.failures = std::atoi(value.c_str());
        } else if (option == "--tries") {
            arguments.tries = std::atoi(value.c_str());
        } else if (option == "--out") {
            arguments.out = value;
        } else if (option == "--replay") {
            arguments.replay = value;
        } else {
            refuse();
        }
    }
    return arguments;
}

// A crash cannot be shrunk, but it can say where it was.
std::array<char, 160> crash_text{};

extern "C" void on_crash(int) {
    std::fputs(crash_text.data(), stderr);
    std::_Exit(1);
}

void name_crash(const Arguments& arguments, std::uint64_t number) {
    std::snprintf(crash_text.data(), crash_text.size(),
                  "crashed; again: ballpit_property_fuzz --backend %s --seed %llu --first %llu --cases 1\n",
                  arguments.backend.c_str(), static_cast<unsigned long long>(arguments.seed),
                  static_cast<unsigned long long>(number));
}

FuzzBackends backends_of(const Arguments& arguments) {
    if (arguments.backend == "cpu") {
        return {[] { return std::make_unique<cpu::CpuBackend<float>>(); }, nullptr, nullptr};
    }
#ifdef BALLPIT_FUZZ_GPU
    auto programs = std::make_shared<gpu::Programs>(test::shader_folder());
    return {[programs] { return std::make_unique<gpu::GpuBackend>(programs); },
            [] { return std::make_unique<cpu::CpuBackend<float>>(); },
            [] {
                const auto messages = gl::take_messages();
                return messages.empty() ? std::nullopt : std::optional(messages.front());
            }};
#else
    std::cerr << "skipped: built without OpenGL\n";
    std::exit(exit_skipped);
#endif
}

void save(const FuzzCase& fuzz_case, const std::filesystem::path& file) {
    std::ofstream stream(file, std::ios::binary);
    stream << case_text(fuzz_case);
    if (!stream.flush()) {
        std::cerr << "cannot write " << file << "\n";
    }
}

FuzzCase made_small(const FuzzCase& fuzz_case, const FuzzFailure& failure, const FuzzBackends& backends, int tries) {
    const auto fails = [&](const FuzzCase& smaller) {
        FuzzTally ignored;
        const auto again = run_fuzz_case(smaller, backends, ignored);
        return again && again->property == failure.property;
    };
    return test::shrunk(fuzz_case, fails, tries);
}

void report(const FuzzCase& fuzz_case, const FuzzFailure& failure, const FuzzBackends& backends,
            const Arguments& arguments, std::uint64_t number) {
    std::cerr << "seed " << arguments.seed << ", case " << number << ": not so: " << failure.property << "\n  "
              << failure.what << "\n  again: ballpit_property_fuzz --backend " << arguments.backend << " --seed "
              << arguments.seed << " --first " << number << " --cases 1" << std::endl;
    const auto file =
        arguments.out / ("fuzz_" + std::to_string(arguments.seed) + "_" + std::to_string(number) + ".json");
    save(fuzz_case, file);  // first as it is: making it small may crash
    const FuzzCase smallest = made_small(fuzz_case, failure, backends, arguments.tries);
    save(smallest, file);
    FuzzTally ignored;
    const auto last = run_fuzz_case(smallest, backends, ignored);
    std::cerr << "  smallest: " << smallest.scene.settings.balls << " balls, " << smallest.substeps
              << " substeps: " << (last ? last->what : "") << "\n  saved: " << std::filesystem::absolute(file).string()
              << "\n  again: ballpit_property_fuzz --backend " << arguments.backend << " --replay " << file.string()
              << std::endl;
}

int replay(const Arguments& arguments, const FuzzBackends& backends) {
    std::stringstream text;
    text << std::ifstream(arguments.replay, std::ios::binary).rdbuf();
    FuzzTally tally;
    const auto failure = run_fuzz_case(test::parse_case(text.str(), arguments.replay), backends, tally);
    std::cout << (failure ? "not so: " + failure->property + "\n  " + failure->what : "every property holds") << "\n";
    return failure ? 1 : 0;
}

int fuzz(const Arguments& arguments, const FuzzBackends& backends) {
    const auto start = std::chrono::steady_clock::now();
    const auto seconds = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    FuzzTally tally;
    std::uint64_t run = 0;
    int failures = 0;
    while (run < arguments.cases && seconds() < arguments.seconds && failures < arguments.failures) {
        const std::uint64_t number = arguments.first + run++;
        if (arguments.verbose) {
            std::cout << "case " << number << std::endl;
        }
        name_crash(arguments, number);
        const FuzzCase fuzz_case = test::make_fuzz_case(arguments.seed, number);
        if (const auto failure = run_fuzz_case(fuzz_case, backends, tally)) {
            ++failures;
            report(fuzz_case, *failure, backends, arguments, number);
        }
    }
    std::cout << run << " cases on " << backends.device()->device() << " in " << seconds() << " s, " << failures
              << " failed: " << tally.substeps << " substeps looked at, " << tally.changes << " changes and "
              << tally.refused << " refused, " << tally.stepped_back << " times back and forth, balls lost in "
              << tally.quarantined << " cases, energy bounded in " << tally.energies << "\n";
    return failures == 0 ? 0 : 1;
}

int run(const Arguments& arguments) {
    const FuzzBackends backends = backends_of(arguments);
    return arguments.replay.empty() ? fuzz(arguments, backends) : replay(arguments, backends);
}

int run_with_context(const Arguments& arguments) {
#ifdef BALLPIT_FUZZ_GPU
    if (arguments.backend == "gpu") {
        std::unique_ptr<gl::Context> context;
        try {
            context = std::make_unique<gl::Context>(gl::ContextOptions{
                .title = "Ball Pit fuzz", .width = 320, .height = 240, .visible = false, .debug = true});
        } catch (const std::exception& error) {
            std::cerr << "skipped: no OpenGL 4.3: " << error.what() << "\n";
            return exit_skipped;
        }
        if (!context->has_compute()) {
            std::cerr << "skipped: this context has OpenGL " << context->version() << "\n";
            return exit_skipped;
        }
        gl::collect_messages();
        return run(arguments);
    }
#endif
    return run(arguments);
}

}  // namespace

int main(int count, char** values) {
    const Arguments arguments = parse(count, values);
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGILL}) {
        std::signal(signal, on_crash);
    }
    try {
        return run_with_context(arguments);
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 2;
    }
}
