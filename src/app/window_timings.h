// What the last seconds looked like: frame rate, and a history a stage. Numbers on screen change four times a second,
// so that they can be read.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/backend.h"
#include "ui/state.h"

namespace ballpit::app {

/// The last 512 samples of one row.
class TimingHistory {
public:
    void add(double ms);
    /// Takes over what came in since the last call as "now", and finds the median of all.
    void refresh();

    double now_ms() const { return now_ms_; }
    double median_ms() const { return median_ms_; }
    std::span<const float> samples() const;  // oldest first

private:
    std::vector<float> samples_;  // the newest at the end; longer than is shown, so that it is rarely moved
    double sum_ms_ = 0.0;
    int added_ = 0;
    double now_ms_ = 0.0;
    double median_ms_ = 0.0;
};

/// The four stages, the picture and the panels.
class WindowTimings {
public:
    /// Mean over the substeps that have arrived, as one sample a stage.
    void add_substeps(std::span<const StageTimes> times);
    void add_frame(double picture_ms, double panels_ms);
    void refresh();
    std::span<const ui::TimingRow> rows();
    /// A whole substep, as it was lately; nothing before the first was timed.
    std::optional<double> substep_ms() const;

private:
    static constexpr std::size_t picture = stage_count;
    static constexpr std::size_t panels = stage_count + 1;

    std::array<TimingHistory, stage_count + 2> histories_;
    std::vector<ui::TimingRow> rows_;
};

/// Means over the frames of a quarter of a second.
class FrameRate {
public:
    /// A frame that took `busy_s` of work within `wall_s`, and simulated `simulated_s`. True when new means are there.
    bool add(double busy_s, double wall_s, double simulated_s);

    double fps() const { return busy_ms_ > 0.0 ? 1000.0 / busy_ms_ : 0.0; }
    double frame_ms() const { return busy_ms_; }
    double achieved_speed() const { return achieved_speed_; }  // simulated seconds a second

private:
    int frames_ = 0;
    double busy_s_ = 0.0;
    double wall_s_ = 0.0;
    double simulated_s_ = 0.0;
    double busy_ms_ = 0.0;
    double achieved_speed_ = 0.0;
};

}  // namespace ballpit::app
