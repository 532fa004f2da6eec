#include "app/bench_timer.h"

#include <utility>

#include "core/stopwatch.h"

namespace ballpit::app {

void BenchTimer::begin() {
    if (on_device_) {
        device_.begin();
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        return;
    }
    spans_.emplace_back();
    last_ = Clock::now();
}

void BenchTimer::mark() {
    if (on_device_) {
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        device_.mark(0);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        return;
    }
    const double ms = milliseconds_since(last_);
    last_ = Clock::now();
    spans_.back().push_back(ms);
}

void BenchTimer::end() {
    if (on_device_) {
        device_.end();
    }
}

std::vector<std::vector<double>> BenchTimer::take() {
    if (!on_device_) {
        return std::exchange(spans_, {});
    }
    std::vector<std::vector<double>> spans;
    for (const gl::SpanTimer::Span& span : device_.take()) {
        std::vector<double>& parts = spans.emplace_back();
        for (const gl::SpanTimer::Part& part : span) {
            parts.push_back(part.ms);
        }
    }
    return spans;
}

std::vector<double> single_parts(const std::vector<std::vector<double>>& spans) {
    std::vector<double> parts;
    parts.reserve(spans.size());
    for (const auto& span : spans) {
        parts.push_back(span.at(0));
    }
    return parts;
}

}  // namespace ballpit::app
