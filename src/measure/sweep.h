// What each choice costs and how exact it is: the same run of a scene with other substeps, other integrators, with and
// without compensated sums. Each run is compared with a reference in double and small substeps, metered, and timed. It
// goes on in slices, so that a window stays quick, and may be stopped anywhere.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "measure/collision_probe.h"
#include "measure/energy_balance.h"
#include "measure/sweep_run.h"
#include "measure/trajectory.h"

namespace ballpit::measure {

/// One choice.
struct SweepPoint {
    Integrator integrator = Integrator::leapfrog;
    std::uint32_t substeps = 1;
    bool compensated = false;
    std::uint32_t grid_reuse = 1;
    friend bool operator==(const SweepPoint&, const SweepPoint&) = default;
};

/// The settings with this choice; cells stay as wide as they are.
Settings with_point(Settings settings, const SweepPoint& point);
/// The choice that these settings are.
SweepPoint point_of(const Settings& settings);

struct SweepQuestion {
    Scene scene;
    Settings settings;
    std::uint64_t seed = 0;
    std::vector<SweepPoint> points;
    double seconds = 1.0;   // simulated, of each run
    double limit_s = 20.0;  // of the wall clock, for one run: one that would take longer is broken off
};

/// What makes backends that belong to the sweep: those that are measured, and the reference in double.
struct SweepBackends {
    std::function<std::unique_ptr<Backend>()> device;
    std::function<std::unique_ptr<Backend>()> reference;
};

struct SweepRow {
    SweepPoint point;
    double substeps_a_contact = 0.0;  // Nc of two of the lightest balls; 0 where nothing touches anything
    double ms_a_second = 0.0;         // of the wall clock for a simulated second: median of the steps
    double fast_ms_a_second = 0.0;    // quartiles
    double slow_ms_a_second = 0.0;
    std::optional<double> position;       // m, rms: the largest up to the horizon
    std::vector<double> position_at;      // m, rms, after each step; beyond the horizon it says nothing
    std::optional<double> energy;         // 1/s: energy made or eaten, a second, over that of the start
    std::optional<double> overlap;        // largest, in diameters
    std::optional<double> restitution;    // 95 % of the probe's collisions err by less
    double cell_factor = 1.0;             // where a grid is used again: wide enough for a run before, which measured it
    std::optional<std::uint32_t> missed;  // ends of contacts that a used grid did not show, where they are counted
    bool finite = true;
    std::string note;  // why something is missing; else empty
};

enum class SweepMetric { position, energy, overlap, restitution };
inline constexpr std::array<std::string_view, 4> sweep_metric_names = {"position", "energy", "overlap", "restitution"};
/// The settings that this row was measured with.
Settings with_row(Settings settings, const SweepRow& row);

std::optional<double> metric_of(const SweepRow& row, SweepMetric metric);

class Sweep {
public:
    Sweep(SweepQuestion question, SweepBackends backends);

    /// Works for about so long. False when all is done. Throws what Backend::load throws.
    bool advance(double budget_ms);
    bool done() const { return stage_ == Stage::done; }
    /// From 0 to 1, in time, as far as it can be told.
    double progress() const;
    /// s of the wall clock; nothing until something was measured.
    std::optional<double> seconds_left() const;

    /// Those that are done; the last one that was begun may be cut short at any moment.
    std::span<const SweepRow> rows() const {
        return std::span(rows_).first(rows_.size() - (done() || rows_.empty() ? 0 : 1));
    }
    const Reference& reference() const { return reference_; }
    /// m: what a position of the scene's size can differ by, unseen.
    double float_floor() const { return float_floor_; }
    std::uint64_t steps() const { return steps_; }
    const ProbeScene& probe_scene() const { return probe_scene_; }
    const SweepQuestion& question() const { return question_; }

private:
    enum class Stage : std::uint8_t { reference, twin, warm_up, fitted, timed, metered, probed, done };

    void work(double budget_ms);
    SweepRow& row() { return rows_.back(); }
    void choose_reference(const BallState& start);
    void begin_reference();
    void advance_reference(double budget_ms);
    void finish_reference();
    void begin_choices();
    void warm_up(double budget_ms);
    void begin_point();
    void advance_fitted(double budget_ms);
    void begin_timed();
    void advance_timed(double budget_ms);
    void advance_metered(double budget_ms);
    void take_records();
    void finish_metered();
    void advance_probe(double budget_ms);
    void next_point();
    bool too_slow();
    std::unique_ptr<SweepRun> run_of(const Settings& settings, bool of_reference) const;
    double ms_left() const;

    SweepQuestion question_;
    SweepBackends backends_;
    Stage stage_ = Stage::reference;
    std::uint64_t steps_ = 0;
    double float_floor_ = 0.0;
    ProbeScene probe_scene_;
    double pair_frequency_ = 0.0;  // rad/s
    std::unique_ptr<SweepRun> run_;
    EnergyBalance balance_;
    double energy_scale_ = 0.0;  // J, at the start, heights counted from the floor
    std::unique_ptr<Backend> probe_backend_;
    std::optional<CollisionProbe> probe_;  // on the backend above
    Reference reference_;
    std::vector<SweepRow> rows_;
    double reference_substep_ms_ = 0.0;  // as measured; 0 until then
    double device_substep_ms_ = 0.0;
    double spent_ms_ = 0.0;
};

}  // namespace ballpit::measure
