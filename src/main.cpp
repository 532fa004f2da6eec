// Parses the command line, runs one command, and turns what goes wrong outside into one sentence and an exit code.
#include <SDL_main.h>

#include <exception>
#include <iostream>
#include <new>

#include "app/commands.h"
#include "app/options.h"
#include "core/error.h"
#include "gl/error.h"

namespace {

using namespace ballpit;

enum ExitCode : int { fine = 0, bad_input = 2, no_device = 3 };

int run(const app::Options& options) {
    switch (options.command) {
        case app::Command::window:
            return app::open_window(options);
        case app::Command::headless:
            return app::run_headless(options);
        case app::Command::check:
            return app::run_check(options);
        case app::Command::bench:
            return app::run_bench(options);
        case app::Command::accuracy:
            return app::run_accuracy(options);
        case app::Command::extremes:
            return app::run_extremes(options);
        case app::Command::scenes:
            return options.ledger ? app::run_ledger(options) : app::run_scenes();
        case app::Command::settings:
            return app::run_settings();
    }
    return fine;
}

int report(const char* what, ExitCode code) {
    std::cerr << "ballpit: " << what << "\n";
    return code;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const auto options = app::parse_options(argc, argv);
        return options ? run(*options) : fine;
    } catch (const InputError& error) {
        return report(error.what(), bad_input);
    } catch (const gl::ShaderError& error) {
        return report(error.what(), bad_input);
    } catch (const gl::Error& error) {
        return report(error.what(), no_device);
    } catch (const DeviceError& error) {
        return report(error.what(), no_device);
    } catch (const std::bad_alloc&) {
        return report("out of memory: ask for fewer balls with --set balls=N", no_device);
    } catch (const std::exception& error) {
        return report(error.what(), no_device);
    }
}
