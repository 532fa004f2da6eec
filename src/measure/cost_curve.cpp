#include "measure/cost_curve.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "core/stopwatch.h"
#include "measure/statistics.h"

namespace ballpit::measure {

namespace {

constexpr std::uint32_t warm_up = 4;
constexpr std::size_t most_samples = 40;
constexpr std::size_t fewest_samples = 5;
constexpr double enough_ms = 250.0;  // of a point, once there are the fewest

double sum_of(const StageTimes& times) { return std::accumulate(times.begin(), times.end(), 0.0); }

CostPoint point_of(const std::string& sort, std::uint32_t balls, std::span<const StageTimes> times) {
    CostPoint point{sort, balls, 0.0, {}};
    std::vector<double> whole;
    for (const StageTimes& one : times) {
        whole.push_back(sum_of(one));
    }
    point.ms = median(whole);
    for (std::size_t stage = 0; stage < stage_count; ++stage) {
        std::vector<double> sample;
        for (const StageTimes& one : times) {
            sample.push_back(one[stage]);
        }
        point.stage_ms[stage] = median(sample);
    }
    return point;
}

}  // namespace

std::vector<std::uint32_t> cost_counts(const Scene& scene, std::uint32_t most) {
    std::vector<std::uint32_t> counts;
    for (std::uint32_t count = 1024; scene.fill && count <= most; count *= 4) {
        counts.push_back(count);
    }
    return counts;
}

std::vector<std::string> cost_sorts() {
    std::vector<std::string> sorts;
    for (const std::string_view name : sort_names) {
        if (name != "auto") {  // one of the others
            sorts.emplace_back(name);
        }
    }
    return sorts;
}

std::optional<double> slope(std::span<const CostPoint> points) {
    const auto last = points.last(std::min<std::size_t>(points.size(), 3));
    if (last.size() < 2) {
        return std::nullopt;
    }
    double x_mean = 0.0;
    double y_mean = 0.0;
    for (const CostPoint& point : last) {
        x_mean += std::log(static_cast<double>(point.balls)) / static_cast<double>(last.size());
        y_mean += std::log(point.ms) / static_cast<double>(last.size());
    }
    double across = 0.0;
    double both = 0.0;
    for (const CostPoint& point : last) {
        const double x = std::log(static_cast<double>(point.balls)) - x_mean;
        across += x * x;
        both += x * (std::log(point.ms) - y_mean);
    }
    return both / across;
}

std::optional<double> cost_at(std::span<const CostPoint> points, double balls) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double low = points[i - 1].balls;
        const double high = points[i].balls;
        if (balls >= low && balls <= high) {
            const double share = std::log(balls / low) / std::log(high / low);
            return std::exp(std::lerp(std::log(points[i - 1].ms), std::log(points[i].ms), share));
        }
    }
    return std::nullopt;
}

CostCurve::CostCurve(CostQuestion question, std::unique_ptr<Backend> backend)
    : question_(std::move(question)), backend_(std::move(backend)) {
    question_.settings.pull.reset();
    if (question_.sorts.empty()) {
        question_.counts.clear();
    }
}

double CostCurve::progress() const {
    const auto points = static_cast<double>(question_.counts.size() * question_.sorts.size());
    return points == 0.0 ? 1.0 : static_cast<double>(count_ * question_.sorts.size() + sort_) / points;
}

std::vector<CostPoint> CostCurve::points(std::string_view sort) const {
    std::vector<CostPoint> found;
    std::ranges::copy_if(points_, std::back_inserter(found), [sort](const CostPoint& p) { return p.sort == sort; });
    return found;
}

bool CostCurve::too_slow(const std::string& sort) const {
    return std::ranges::any_of(
        points_, [&](const CostPoint& point) { return point.sort == sort && point.ms > question_.limit_ms; });
}

// The balls are put into the box once a count; every sort begins with the same state.
void CostCurve::begin_point() {
    Settings settings = question_.settings;
    settings.balls = question_.counts[count_];
    if (!start_) {
        if (simulation_) {
            simulation_->load(question_.scene, settings, question_.seed);
        } else {
            simulation_.emplace(question_.scene, settings, question_.seed, std::move(backend_));
        }
        start_ = simulation_->checkpoint();
    }
    assign_setting(settings, "sort", question_.sorts[sort_]);
    simulation_->restore(*start_);
    simulation_->change(settings);
    simulation_->backend().set_timing(false);
    simulation_->backend().take_times();
    warm_ = 0;
    spent_ms_ = 0.0;
    times_.clear();
    begun_ = true;
}

void CostCurve::end_point() {
    if (!times_.empty()) {
        points_.push_back(point_of(question_.sorts[sort_], question_.counts[count_], times_));
    }
    begun_ = false;
    if (++sort_ == question_.sorts.size()) {
        sort_ = 0;
        ++count_;
        start_.reset();
    }
}

bool CostCurve::advance(double budget_ms) {
    const auto start = std::chrono::steady_clock::now();
    while (!done() && milliseconds_since(start) < budget_ms) {
        if (!begun_) {
            times_.clear();
            if (too_slow(question_.sorts[sort_])) {
                end_point();
                continue;
            }
            begin_point();
        }
        Backend& backend = simulation_->backend();
        backend.set_timing(warm_ >= warm_up);
        const auto before = std::chrono::steady_clock::now();
        simulation_->substep();
        backend.finish();
        if (warm_ < warm_up) {
            ++warm_;
            continue;
        }
        spent_ms_ += milliseconds_since(before);
        for (const StageTimes& times : backend.take_times()) {
            times_.push_back(times);
        }
        if (times_.size() >= most_samples || (times_.size() >= fewest_samples && spent_ms_ > enough_ms)) {
            end_point();
        }
    }
    return !done();
}

}  // namespace ballpit::measure
