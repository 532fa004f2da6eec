// The runs of one choice of a sweep: timed and compared, then metered, then probed.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "core/grid_reuse.h"
#include "core/quarantine.h"
#include "core/stopwatch.h"
#include "measure/statistics.h"
#include "measure/sweep.h"

namespace ballpit::measure {

namespace {

constexpr std::uint32_t probe_slice = 32;  // substeps

// J, of the record's moment, heights counted from the corner of the box to which gravity pulls.
double energy_above_floor(const MeterRecord& record, const Box& box) {
    dvec3 corner(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        corner[axis] = record.gravity[axis] < 0.0 ? box.lower[axis] : box.upper[axis];
    }
    return record.reading.energy() + record.reading.mass * glm::dot(record.gravity, corner);
}

bool all_finite(std::span<const vec4> positions) {
    return std::ranges::all_of(positions,
                               [](const vec4& p) { return std::isfinite(p.x + p.y + p.z) && !in_quarantine(p); });
}

}  // namespace

void Sweep::begin_point() {
    const SweepPoint& point = question_.points[rows_.size()];
    rows_.emplace_back().point = point;
    row().cell_factor = question_.settings.cell_factor;
    if (point.grid_reuse > 1) {
        stage_ = Stage::fitted;
        Settings settings = with_row(question_.settings, row());
        settings.laws.diagnostics = true;  // or nobody measures
        run_ = run_of(settings, false);
    } else {
        begin_timed();
    }
}

// How far balls go while a grid is used says how wide its cells must be.
void Sweep::advance_fitted(double budget_ms) {
    run_->advance(budget_ms);
    if (run_->steps() < steps_ && !too_slow()) {
        return;
    }
    Simulation& simulation = run_->simulation();
    const Status status = read_slot<Status>(simulation.backend(), Slot::status).front();
    const double wide = cell_factor_for(drift(status), simulation.largest_ball_radius());
    row().cell_factor = std::clamp(wide, question_.settings.cell_factor, find_setting("cell_factor")->maximum);
    begin_timed();
}

void Sweep::begin_timed() {
    stage_ = Stage::timed;
    run_ = run_of(with_row(question_.settings, row()), false);
    const double dt = question_.settings.dt / row().point.substeps;
    row().substeps_a_contact = pair_frequency_ > 0.0 ? std::numbers::pi / (pair_frequency_ * dt) : 0.0;
    if (reference_.usable()) {
        row().position_at.push_back(0.0);
    }
}

bool Sweep::too_slow() {
    const double estimate_s = run_->seconds_for(steps_).value_or(0.0);
    if (estimate_s <= question_.limit_s) {
        return false;
    }
    row().note = "broken off: the run would take " + seconds_text(estimate_s) + ", the limit is " +
                 seconds_text(question_.limit_s);
    return true;
}

void Sweep::advance_timed(double budget_ms) {
    const bool ended = run_->advance(budget_ms);
    device_substep_ms_ = run_->substep_ms();
    const bool slow = too_slow();
    if (ended) {
        const auto positions = read_slot<vec4>(run_->simulation().backend(), Slot::positions);
        row().finite = row().finite && all_finite(positions);
        const std::size_t step = row().position_at.size();
        if (reference_.usable() && !slow) {
            row().position_at.push_back(rms_distance(positions, reference_.positions[step]));
        }
    }
    if (!slow && run_->steps() < steps_) {
        return;
    }
    std::vector<double> ms = run_->step_ms();
    if (ms.empty()) {
        ms.push_back(run_->substep_ms() * row().point.substeps);
    }
    row().ms_a_second = median(ms) / question_.settings.dt;
    row().fast_ms_a_second = quantile(ms, 0.25) / question_.settings.dt;
    row().slow_ms_a_second = quantile(ms, 0.75) / question_.settings.dt;
    if (run_->simulation().schedule().keeps_places) {
        row().missed = read_slot<Status>(run_->simulation().backend(), Slot::status).front().missed;
    }
    if (slow) {
        stage_ = Stage::probed;
        return;
    }
    if (reference_.usable()) {
        const auto upto = row().position_at.begin() + static_cast<std::ptrdiff_t>(*reference_.steps + 1);
        row().position = *std::max_element(row().position_at.begin(), upto);
    }
    stage_ = Stage::metered;
    balance_.clear();
    energy_scale_ = 0.0;
    row().overlap = 0.0;
    run_ = run_of(with_row(question_.settings, row()), false);
    run_->simulation().set_metering(true);
}

void Sweep::take_records() {
    for (const MeterRecord& record : run_->simulation().take_records()) {
        if (!balance_.balance()) {
            energy_scale_ = energy_above_floor(record, run_->simulation().scene_box());
        }
        balance_.add(record);
        row().overlap = std::max(*row().overlap, record.reading.max_overlap_share);
    }
}

void Sweep::advance_metered(double budget_ms) {
    run_->advance(budget_ms);
    take_records();
    if (run_->steps() < steps_) {
        return;
    }
    run_->simulation().meter();
    run_->simulation().backend().finish();
    take_records();
    finish_metered();
}

void Sweep::finish_metered() {
    const std::optional<Balance>& balance = balance_.balance();
    if (!row().finite || !balance || !std::isfinite(balance->unexplained())) {
        row().finite = false;
        row().overlap.reset();
        row().note = "blown up: positions are no longer finite";
    } else if (energy_scale_ > 0.0 && balance->time > balance->base_time) {
        row().energy = std::abs(balance->unexplained()) / energy_scale_ / (balance->time - balance->base_time);
    }
    stage_ = Stage::probed;
}

void Sweep::advance_probe(double budget_ms) {
    if (!probe_) {
        probe_backend_ = backends_.device();
        probe_.emplace(*probe_backend_, ProbeQuestion{with_row(question_.settings, row()), probe_scene_});
    }
    const auto start = std::chrono::steady_clock::now();
    while (!probe_->advance(probe_slice)) {
        if (milliseconds_since(start) > budget_ms) {
            return;
        }
    }
    const ProbeResult& result = probe_->result();
    if (result.nothing.empty() && result.unending() == 0) {
        row().restitution = result.restitution_error();
    }
    probe_.reset();
    probe_backend_.reset();
    next_point();
}

void Sweep::next_point() {
    run_.reset();
    if (rows_.size() == question_.points.size()) {
        stage_ = Stage::done;
    } else {
        begin_point();
    }
}

}  // namespace ballpit::measure
