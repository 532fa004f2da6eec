// Time of what a backend does, by the device's clock or, for the CPU, by the wall's.
#pragma once

#include <chrono>
#include <vector>

#include "core/backend.h"
#include "gl/timer.h"

namespace ballpit::app {

class BenchTimer {
public:
    explicit BenchTimer(const Backend& backend) : on_device_(backend.name() == "gpu") {}

    void begin();
    /// Ends the part that began at begin() or at the mark before. A barrier keeps apart what lies before a mark and
    /// behind it: llvmpipe would look at its clock only when it next has to wait for something.
    void mark();
    void end();

    /// ms of the parts of each span since the last call. For the device: after Backend::finish().
    std::vector<std::vector<double>> take();

private:
    using Clock = std::chrono::steady_clock;

    bool on_device_;
    gl::SpanTimer device_;
    Clock::time_point last_;
    std::vector<std::vector<double>> spans_;
};

/// Of spans of one part each.
std::vector<double> single_parts(const std::vector<std::vector<double>>& spans);

}  // namespace ballpit::app
