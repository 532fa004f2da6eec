#include "gpu/slicer.h"

#include <algorithm>
#include <cmath>

namespace ballpit::gpu {

namespace {

constexpr double long_ms = 100.0;  // of a slice: a screen that waits for it is felt to stop
constexpr double short_ms = 10.0;
constexpr std::uint32_t most_slower = 4096;
constexpr std::uint32_t seldom = 16;  // a time stamp costs as much as a dispatch

}  // namespace

void Slicer::load(const BallState& state, const Schedule& schedule) {
    slower_ = 1;
    density_ = 0.0;
    if (could_be_long(schedule) && schedule.features.has(Feature::contact)) {
        density_ = local_density(state.positions, schedule.grid);
    }
}

bool Slicer::could_be_long(const Schedule& schedule) const {
    const auto balls = static_cast<double>(schedule.ball_count);
    return balls * balls > limit_;
}

std::uint32_t Slicer::slices(const Schedule& schedule, double cells) const {
    if (!could_be_long(schedule)) {
        return 1;
    }
    const double wanted = std::ceil(pairs_of(schedule, density_, cells) / limit_) * slower_;
    const double most = std::ceil(schedule.ball_count / static_cast<double>(GROUP_SIZE));
    return static_cast<std::uint32_t>(std::clamp(wanted, 1.0, most));
}

void Slicer::begin(const Schedule& schedule) {
    timing_ = could_be_long(schedule) && timed_slices_ == 0 && dispatches_++ % seldom == 0;
    if (timing_) {
        timer_.begin();
    }
}

void Slicer::end(std::uint32_t slices) {
    if (timing_) {
        timer_.mark(0);
        timer_.end();
        timed_slices_ = slices;
    } else if (timed_slices_ != 0) {
        look_at_time();
    }
}

void Slicer::look_at_time() {
    for (const gl::SpanTimer::Span& span : timer_.take()) {
        const double ms = span.front().ms / timed_slices_;
        if (ms > long_ms) {
            slower_ = std::min(slower_ * 2, most_slower);
        } else if (ms < short_ms && slower_ > 1) {
            slower_ /= 2;
        }
        timed_slices_ = 0;
    }
    if (timer_.take_lost() != 0) {
        timed_slices_ = 0;  // another one will tell
    }
}

}  // namespace ballpit::gpu
