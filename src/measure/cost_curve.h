// What a substep costs at other numbers of balls, with each sort: copies of a scene on a backend of their own. It goes
// on in slices, so that a window stays quick, and may be stopped anywhere.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/simulation.h"

namespace ballpit::measure {

struct CostPoint {
    std::string sort;
    std::uint32_t balls = 0;
    double ms = 0.0;  // a substep, median
    StageTimes stage_ms{};
};

struct CostQuestion {
    Scene scene;
    Settings settings;
    std::uint64_t seed = 0;
    std::vector<std::uint32_t> counts;  // ascending
    std::vector<std::string> sorts;
    double limit_ms = 60.0;  // of a substep: a sort that takes longer is not measured with more balls
};

/// Counts worth measuring, four times as many each, from 1024 to `most`; none where the scene lists its balls, so that
/// there is no other number of them.
std::vector<std::uint32_t> cost_counts(const Scene& scene, std::uint32_t most);

/// Every sort that is one of its own.
std::vector<std::string> cost_sorts();

/// Exponent p of ms ~ balls^p: the straight line through the last three points in the logarithms (least squares).
/// Nothing for fewer than two.
std::optional<double> slope(std::span<const CostPoint> points);

/// ms at this count, between points along straight lines in the logarithms; nothing outside of them.
std::optional<double> cost_at(std::span<const CostPoint> points, double balls);

class CostCurve {
public:
    CostCurve(CostQuestion question, std::unique_ptr<Backend> backend);

    /// Works for about so long; loading many balls takes longer. False when all is done. Throws what
    /// Simulation::load throws.
    bool advance(double budget_ms);
    bool done() const { return count_ >= question_.counts.size(); }
    /// Of the points, from 0 to 1; a point with more balls takes longer.
    double progress() const;
    const CostQuestion& question() const { return question_; }

    /// Of one sort, ascending.
    std::vector<CostPoint> points(std::string_view sort) const;
    std::span<const CostPoint> points() const { return points_; }

private:
    void begin_point();
    void end_point();
    bool too_slow(const std::string& sort) const;

    CostQuestion question_;
    std::unique_ptr<Backend> backend_;
    std::optional<Simulation> simulation_;
    std::optional<Checkpoint> start_;
    std::size_t count_ = 0;
    std::size_t sort_ = 0;
    bool begun_ = false;
    std::uint32_t warm_ = 0;  // substeps that were not timed
    double spent_ms_ = 0.0;   // timed
    std::vector<StageTimes> times_;
    std::vector<CostPoint> points_;
};

}  // namespace ballpit::measure
