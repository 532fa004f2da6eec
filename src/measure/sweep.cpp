#include "measure/sweep.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/stopwatch.h"
#include "measure/float_spacing.h"

namespace ballpit::measure {

namespace {

constexpr std::uint32_t most_reference_balls = 4096;
constexpr double reference_substeps_a_contact = 400.0;
// Where the reference is cheap it is this much finer than the finest choice, too.
constexpr std::uint32_t finer_than_choices = 4;
constexpr double cheap_ball_substeps = 1e8;
constexpr double reference_patience = 10.0;  // times the limit of a run
constexpr double warm_up_ms = 1000.0;
constexpr double ms_a_s = 1000.0;

}  // namespace

Settings with_point(Settings settings, const SweepPoint& point) {
    settings.integrator = point.integrator;
    settings.substeps = point.substeps;
    settings.laws.compensated = point.compensated;
    settings.grid_reuse = point.grid_reuse;
    return settings;
}

Settings with_row(Settings settings, const SweepRow& row) {
    settings.cell_factor = row.cell_factor;
    return with_point(settings, row.point);
}

SweepPoint point_of(const Settings& settings) {
    return {settings.integrator, settings.substeps, settings.laws.compensated, settings.grid_reuse};
}

std::optional<double> metric_of(const SweepRow& row, SweepMetric metric) {
    switch (metric) {
        case SweepMetric::position:
            return row.position;
        case SweepMetric::energy:
            return row.energy;
        case SweepMetric::overlap:
            return row.overlap;
        case SweepMetric::restitution:
            return row.restitution;
    }
    return std::nullopt;
}

Sweep::Sweep(SweepQuestion question, SweepBackends backends)
    : question_(std::move(question)), backends_(std::move(backends)) {
    question_.settings.pull.reset();
    const double dt = question_.settings.dt;
    steps_ =
        dt > 0.0 ? std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::llround(question_.seconds / dt))) : 0;
    if (steps_ == 0 || question_.points.empty() || question_.settings.balls == 0) {
        reference_.note = "There is nothing to run.";
        stage_ = Stage::done;
        return;
    }
    begin_reference();
}

std::unique_ptr<SweepRun> Sweep::run_of(const Settings& settings, bool of_reference) const {
    return std::make_unique<SweepRun>(question_.scene, settings, question_.seed,
                                      of_reference ? backends_.reference() : backends_.device());
}

// What is asked of the scene before anything moves.
void Sweep::choose_reference(const BallState& start) {
    Simulation& simulation = run_->simulation();
    const Settings& settings = question_.settings;
    probe_scene_ = measure::probe_scene(start, settings, simulation.box(), simulation.variety());
    const bool touches = settings.laws.contact || settings.laws.walls;
    pair_frequency_ = touches ? contact_frequency({settings, probe_scene_}, !settings.laws.contact) : 0.0;
    float_floor_ = float_spacing(probe_scene_.distance);
    const double contacts_a_step = pair_frequency_ * settings.dt / std::numbers::pi;
    reference_.substeps =
        std::max(1u, static_cast<std::uint32_t>(std::ceil(reference_substeps_a_contact * contacts_a_step)));
    std::uint32_t finest = 1;
    for (const SweepPoint& point : question_.points) {
        finest = std::max(finest, point.substeps);
    }
    const double finer = static_cast<double>(finer_than_choices) * finest;
    if (finer * static_cast<double>(steps_) * start.count() < cheap_ball_substeps) {
        reference_.substeps = std::max(reference_.substeps, static_cast<std::uint32_t>(finer));
    }
    reference_.substeps_a_contact = contacts_a_step > 0.0 ? reference_.substeps / contacts_a_step : 0.0;
    for (const vec4& ball : start.positions) {
        reference_.diameter += 2.0 * static_cast<double>(ball.w) / start.count();
    }
}

void Sweep::begin_reference() {
    Settings settings = with_point(question_.settings, {});
    run_ = run_of(settings, true);
    const BallState start = run_->simulation().raw_state();
    choose_reference(start);
    if (start.count() > most_reference_balls) {
        reference_.note = "Positions are not compared: the reference in double is for at most " +
                          std::to_string(most_reference_balls) + " balls.";
        begin_choices();
        return;
    }
    settings.substeps = reference_.substeps;
    run_->simulation().change(settings);
    reference_.positions.push_back(start.positions);
}

void Sweep::advance_reference(double budget_ms) {
    const bool ended = run_->advance(budget_ms);
    reference_substep_ms_ = run_->substep_ms();
    const double estimate_s = run_->seconds_for(2 * steps_).value_or(0.0);  // its twin, too
    if (estimate_s > reference_patience * question_.limit_s) {
        reference_.note = "Positions are not compared: the reference in double would take " + seconds_text(estimate_s) +
                          ", more than ten times the limit of a run.";
        begin_choices();
        return;
    }
    if (!ended) {
        return;
    }
    auto positions = read_slot<vec4>(run_->simulation().backend(), Slot::positions);
    if (stage_ == Stage::reference) {
        reference_.positions.push_back(std::move(positions));
    } else {
        reference_.twin_at.push_back(rms_distance(positions, reference_.positions[reference_.twin_at.size()]));
    }
    if (run_->steps() == steps_) {
        finish_reference();
    }
}

// After the reference its twin, after the twin the choices.
void Sweep::finish_reference() {
    if (stage_ == Stage::twin) {
        reference_.steps = horizon_of(reference_.twin_at, reference_.diameter);
        begin_choices();
        return;
    }
    stage_ = Stage::twin;
    Settings settings = with_point(question_.settings, {});
    settings.substeps = reference_.substeps;
    run_ = run_of(settings, true);
    const BallState moved = moved_by_a_rounding(run_->simulation().raw_state());
    run_->simulation().backend().write(Slot::positions, std::as_bytes(std::span(moved.positions)));
    reference_.twin_at = {rms_distance(moved.positions, reference_.positions.front())};
}

bool Sweep::advance(double budget_ms) {
    const auto start = std::chrono::steady_clock::now();
    work(budget_ms);
    spent_ms_ += milliseconds_since(start);
    return !done();
}

void Sweep::work(double budget_ms) {
    switch (stage_) {
        case Stage::reference:
        case Stage::twin:
            advance_reference(budget_ms);
            break;
        case Stage::warm_up:
            warm_up(budget_ms);
            break;
        case Stage::fitted:
            advance_fitted(budget_ms);
            break;
        case Stage::timed:
            advance_timed(budget_ms);
            break;
        case Stage::metered:
            advance_metered(budget_ms);
            break;
        case Stage::probed:
            advance_probe(budget_ms);
            break;
        case Stage::done:
            break;
    }
}

// A device that was idle while the reference was computed is slow at first.
void Sweep::begin_choices() {
    run_ = run_of(with_point(question_.settings, question_.points.front()), false);
    if (run_->simulation().backend().name() == "gpu") {
        stage_ = Stage::warm_up;
    } else {
        begin_point();
    }
}

void Sweep::warm_up(double budget_ms) {
    run_->advance(std::min(budget_ms, warm_up_ms));
    if (run_->spent_ms() >= warm_up_ms) {
        begin_point();
    }
}

// As if every run took a substep as long as the last one did.
double Sweep::ms_left() const {
    if (done()) {
        return 0.0;
    }
    const auto steps = static_cast<double>(steps_);
    const bool of_reference = stage_ == Stage::reference || stage_ == Stage::twin;
    double substeps = 0.0;
    for (std::size_t i = rows_.size(); i < question_.points.size(); ++i) {
        const double runs = question_.points[i].grid_reuse > 1 ? 3.0 : 2.0;
        substeps += runs * steps * question_.points[i].substeps;
    }
    double here = 0.0;
    if (run_ != nullptr && stage_ != Stage::warm_up) {
        here = steps * run_->simulation().settings().substeps - static_cast<double>(run_->substeps());
        const double runs_after = stage_ == Stage::fitted                                ? 2.0
                                  : stage_ == Stage::timed || stage_ == Stage::reference ? 1.0
                                                                                         : 0.0;
        here += runs_after * steps * run_->simulation().settings().substeps;
    }
    const double device_ms = device_substep_ms_ > 0.0 ? device_substep_ms_ : reference_substep_ms_;
    return of_reference ? here * reference_substep_ms_ + substeps * device_ms : (here + substeps) * device_ms;
}

double Sweep::progress() const { return done() ? 1.0 : spent_ms_ / std::max(1.0, spent_ms_ + ms_left()); }

std::optional<double> Sweep::seconds_left() const {
    return reference_substep_ms_ > 0.0 || device_substep_ms_ > 0.0 ? std::optional(ms_left() / ms_a_s) : std::nullopt;
}

}  // namespace ballpit::measure
