#include "app/progress_line.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <sstream>
#include <string>
#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace ballpit::app {

namespace {

constexpr int bar_width = 30;
constexpr std::size_t line_width = 70;

bool is_terminal() {
#ifdef _WIN32
    return _isatty(_fileno(stderr)) != 0;
#else
    return isatty(fileno(stderr)) != 0;
#endif
}

}  // namespace

ProgressLine::ProgressLine() : shown_(is_terminal()) {}

void ProgressLine::show(double share, std::optional<double> seconds_left) const {
    if (!shown_) {
        return;
    }
    const int done = std::clamp(static_cast<int>(share * bar_width), 0, bar_width);
    std::ostringstream line;
    line << '[' << std::string(static_cast<std::size_t>(done), '#')
         << std::string(static_cast<std::size_t>(bar_width - done), '.') << "] " << static_cast<int>(100.0 * share)
         << " %";
    if (seconds_left) {
        line << ", " << static_cast<long long>(*seconds_left) << " s left";
    }
    std::string text = line.str();
    text.resize(line_width, ' ');
    std::cerr << '\r' << text << std::flush;
}

void ProgressLine::clear() const {
    if (shown_) {
        std::cerr << '\r' << std::string(line_width, ' ') << '\r' << std::flush;
    }
}

}  // namespace ballpit::app
