#include "app/bench_limits.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstring>
#include <functional>
#include <numeric>
#include <thread>
#include <vector>

#include "app/bench_timer.h"
#include "core/schedule.h"
#include "core/stopwatch.h"
#include "gl/buffer.h"
#include "gl/program.h"

namespace ballpit::app {

namespace {

constexpr std::array<std::size_t, 8> copied_bytes = {64u << 10, 256u << 10, 1u << 20,   4u << 20,
                                                     16u << 20, 64u << 20,  128u << 20, 512u << 20};
constexpr std::size_t worth_threads = 2u << 20;  // bytes: a smaller copy is done before a thread has begun
constexpr int rounds = 5;
constexpr int copies_a_round = 8;
constexpr double longest_round_ms = 200.0;  // larger copies than this are not tried: they tell nothing new

// 0 where the clock gave none.
double least(const std::vector<double>& sample) { return sample.empty() ? 0.0 : *std::ranges::min_element(sample); }

// ms between two looks at the clock, one straight after the other.
std::vector<double> empty_spans(Backend& backend) {
    constexpr int looks = 256;
    std::vector<double> spans;
    if (backend.name() == "gpu") {
        gl::SpanTimer timer;
        for (int i = 0; i < looks; ++i) {
            timer.begin();
            timer.mark(0);
            timer.end();
        }
        backend.finish();
        for (const gl::SpanTimer::Span& span : timer.take()) {
            spans.push_back(span.at(0).ms);
        }
        return spans;
    }
    for (int i = 0; i < looks; ++i) {
        const auto start = std::chrono::steady_clock::now();
        spans.push_back(milliseconds_since(start));
    }
    return spans;
}

// The clock's step is what all differences are multiples of (whole nanoseconds, as both clocks count).
void measure_clock(Backend& backend, measure::DeviceLimits& limits) {
    const std::vector<double> spans = empty_spans(backend);
    long long step = 0;
    for (const double ms : spans) {
        step = std::gcd(step, std::llround(ms * 1e6));
    }
    limits.clock_step_ms = static_cast<double>(step) * 1e-6;
    limits.least_span_ms = least(spans);
}

// The best of some rounds, in ms a copy.
double time_copies(Backend& backend, const std::function<void()>& copy) {
    BenchTimer timer(backend);
    copy();  // warm-up: pages, caches, clocks
    backend.finish();
    for (int round = 0; round < rounds; ++round) {
        timer.begin();
        for (int i = 0; i < copies_a_round; ++i) {
            copy();
        }
        timer.mark();
        timer.end();
        backend.finish();
    }
    return least(single_parts(timer.take())) / copies_a_round;
}

class DeviceCopy {
public:
    explicit DeviceCopy(const std::filesystem::path& shaders) {
        const std::array stages = {gl::ShaderStage{GL_COMPUTE_SHADER, gl::load_shader(shaders, "copy.comp")}};
        program_ = gl::Program(stages);
        constants_ = program_.uniform("dispatch_constants");
    }

    void make_room(std::size_t bytes) {
        from_ = gl::Buffer("copied from", bytes);
        to_ = gl::Buffer("copied to", bytes);
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        from_.write(std::vector<std::byte>(bytes, std::byte{1}));
    }

    void run() const {
        program_.use();
        from_.bind_base(GL_SHADER_STORAGE_BUFFER, SLOT_POSITIONS);
        to_.bind_base(GL_SHADER_STORAGE_BUFFER, SLOT_NEXT_POSITIONS);
        const auto count = static_cast<GLuint>(from_.size() / sizeof(vec4));
        const std::array<GLuint, 4> constants = {count, 0, 0, 0};
        glUniform4uiv(constants_, 1, constants.data());
        const Groups groups = groups_for(count, GROUP_SIZE);
        glDispatchCompute(groups.x, groups.y, 1);
    }

private:
    gl::Program program_;
    GLint constants_ = -1;
    gl::Buffer from_;
    gl::Buffer to_;
};

// Each thread copies a part of its own.
class ThreadedCopy {
public:
    void make_room(std::size_t bytes) {
        from_.assign(bytes, std::byte{1});
        to_.assign(bytes, std::byte{0});
    }

    void run() {
        const std::size_t threads =
            from_.size() < worth_threads ? 1 : std::max(1u, std::thread::hardware_concurrency());
        const std::size_t part = from_.size() / threads;
        std::vector<std::jthread> others;
        for (std::size_t i = 1; i < threads; ++i) {
            others.emplace_back([this, i, part] { std::memcpy(&to_[i * part], &from_[i * part], part); });
        }
        std::memcpy(to_.data(), from_.data(), part);
    }

private:
    std::vector<std::byte> from_;
    std::vector<std::byte> to_;
};

template <class Copy>
void measure_copies(Backend& backend, Copy copy, measure::DeviceLimits& limits) {
    const StorageLimits room = backend.storage_limits();
    for (const std::size_t bytes : copied_bytes) {
        if (bytes / 2 > room.block_bytes || (room.free_bytes && 2 * bytes > *room.free_bytes)) {
            return;
        }
        copy.make_room(bytes / 2);
        const double ms = time_copies(backend, [&copy] { copy.run(); });
        if (ms > 0.0) {
            limits.copies.push_back({bytes, measure::gb_s(bytes, ms)});
        }
        if (ms * copies_a_round > longest_round_ms) {
            return;
        }
    }
}

}  // namespace

measure::DeviceLimits measure_limits(Backend& backend, const std::filesystem::path& shaders) {
    measure::DeviceLimits limits;
    if (backend.name() == "gpu") {
        measure_copies(backend, DeviceCopy(shaders), limits);
    } else {
        measure_copies(backend, ThreadedCopy(), limits);
    }
    measure_clock(backend, limits);  // last: the device is awake
    return limits;
}

}  // namespace ballpit::app
