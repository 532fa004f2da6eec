// Runs the tests that need an OpenGL 4.3 context. Where none can be made they are skipped with the reason
// (exit code 77, which CTest shows as skipped), or fail if --require-gpu or BALLPIT_REQUIRE_GPU=1 says so.
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "support/gl_fixture.h"
#include "support/session.h"

namespace {

constexpr int exit_skipped = 77;

bool is_set(const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && std::string_view(value) == "1";
}

int run_with_context(Catch::Session& session, bool required) {
    try {
        ballpit::test::make_context();
    } catch (const std::exception& error) {
        std::cerr << (required ? "failed" : "skipped") << ": the GPU tests need OpenGL 4.3: " << error.what() << '\n';
        return required ? EXIT_FAILURE : exit_skipped;
    }
    const int failures = session.run();
    ballpit::test::close_context();
    return failures;
}

}  // namespace

int main(int argc, char** argv) {
    bool required = is_set("BALLPIT_REQUIRE_GPU");
    std::vector<const char*> arguments;
    for (int i = 0; i < argc; ++i) {
        if (std::string_view(argv[i]) == "--require-gpu") {
            required = true;
        } else {
            arguments.push_back(argv[i]);
        }
    }
    Catch::Session session;
    const int error = session.applyCommandLine(static_cast<int>(arguments.size()), arguments.data());
    if (error != 0) {
        return error;
    }
    const auto& config = session.configData();
    if (config.showHelp || config.listTests || config.listTags) {
        return session.run();
    }
    return run_with_context(session, required);
}
