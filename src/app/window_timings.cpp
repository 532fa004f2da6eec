#include "app/window_timings.h"

#include "measure/statistics.h"
#include "view/palette.h"

namespace ballpit::app {

namespace {

constexpr std::size_t shown_samples = 512;
constexpr double refresh_s = 0.25;

}  // namespace

void TimingHistory::add(double ms) {
    if (samples_.size() == 2 * shown_samples) {
        samples_.erase(samples_.begin(), samples_.begin() + shown_samples);
    }
    samples_.push_back(static_cast<float>(ms));
    sum_ms_ += ms;
    ++added_;
}

void TimingHistory::refresh() {
    if (added_ == 0) {
        return;
    }
    now_ms_ = sum_ms_ / added_;
    sum_ms_ = 0.0;
    added_ = 0;
    const auto shown = samples();
    median_ms_ = measure::median({shown.begin(), shown.end()});
}

std::span<const float> TimingHistory::samples() const {
    const std::span<const float> all(samples_);
    return all.last(std::min(all.size(), shown_samples));
}

void WindowTimings::add_substeps(std::span<const StageTimes> times) {
    if (times.empty()) {
        return;
    }
    for (std::size_t stage = 0; stage < stage_count; ++stage) {
        double sum = 0.0;
        for (const StageTimes& substep : times) {
            sum += substep[stage];
        }
        if (sum == 0.0) {
            histories_[stage] = {};  // this schedule does without
        } else {
            histories_[stage].add(sum / static_cast<double>(times.size()));
        }
    }
}

void WindowTimings::add_frame(double picture_ms, double panels_ms) {
    histories_[picture].add(picture_ms);
    histories_[panels].add(panels_ms);
}

void WindowTimings::refresh() {
    for (TimingHistory& history : histories_) {
        history.refresh();
    }
}

std::span<const ui::TimingRow> WindowTimings::rows() {
    rows_.clear();
    const bool counted = !histories_[static_cast<std::size_t>(Stage::counting_sort)].samples().empty();
    const auto other_sort = static_cast<std::size_t>(counted ? Stage::bitonic_sort : Stage::counting_sort);
    for (std::size_t i = 0; i < histories_.size(); ++i) {
        const bool stage = i < stage_count;
        if (i == other_sort) {
            continue;
        }
        ui::TimingRow& row = rows_.emplace_back();
        row.name = stage ? stage_names[i] : i == picture ? "drawing" : "panels";
        row.per = stage ? "substep" : "frame";
        row.colour = view::categorical(static_cast<std::uint32_t>(i));
        row.now_ms = histories_[i].now_ms();
        row.median_ms = histories_[i].median_ms();
        row.history = histories_[i].samples();
    }
    return rows_;
}

std::optional<double> WindowTimings::substep_ms() const {
    double sum = 0.0;
    for (std::size_t stage = 0; stage < stage_count; ++stage) {
        sum += histories_[stage].now_ms();
    }
    return sum > 0.0 ? std::optional(sum) : std::nullopt;
}

bool FrameRate::add(double busy_s, double wall_s, double simulated_s) {
    ++frames_;
    busy_s_ += busy_s;
    wall_s_ += wall_s;
    simulated_s_ += simulated_s;
    if (wall_s_ < refresh_s) {
        return false;
    }
    busy_ms_ = 1000.0 * busy_s_ / frames_;
    achieved_speed_ = simulated_s_ / wall_s_;
    frames_ = 0;
    busy_s_ = wall_s_ = simulated_s_ = 0.0;
    return true;
}

}  // namespace ballpit::app
