#include "measure/collision_probe.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/contact.h"
#include "core/quarantine.h"
#include "measure/statistics.h"

namespace ballpit::measure {

namespace {

// Substeps that the device remembers. A longer contact is read piece by piece: what is kept of it does not grow.
constexpr std::uint32_t history_entries = 128;
constexpr double beyond_measure = 1e9;  // instead of what is not finite

double finite(double value) { return std::isfinite(value) ? value : beyond_measure; }

Spread spread_of(const std::vector<double>& values, double exact) {
    Spread spread;
    spread.exact = exact;
    spread.worst = exact;
    std::vector<double> errors;
    for (const double value : values) {
        spread.mean += value / static_cast<double>(values.size());
        errors.push_back(std::abs(value - exact));
        if (errors.back() > std::abs(spread.worst - exact)) {
            spread.worst = value;
        }
    }
    double squares = 0.0;
    for (const double value : values) {
        squares += (value - spread.mean) * (value - spread.mean);
    }
    spread.deviation = std::sqrt(squares / static_cast<double>(values.size()));
    spread.error = quantile(std::move(errors), 0.95);
    return spread;
}

template <class Value>
double largest(const std::vector<ProbeGroup>& groups, const Value& value) {
    double most = 0.0;
    for (const ProbeGroup& group : groups) {
        most = std::max(most, value(group));
    }
    return most;
}

}  // namespace

double ProbeResult::restitution_error() const {
    return largest(groups, [](const ProbeGroup& g) { return g.passes_through() ? 0.0 : g.restitution.error; });
}

double ProbeResult::overlap_error() const {
    return largest(groups, [](const ProbeGroup& g) { return g.passes_through() ? 0.0 : g.overlap.error; });
}

double ProbeResult::softness() const {
    return largest(groups, [](const ProbeGroup& g) { return g.overlap.exact; });
}

std::uint32_t ProbeResult::unending() const {
    std::uint32_t sum = 0;
    for (const ProbeGroup& group : groups) {
        sum += group.unending;
    }
    return sum;
}

CollisionProbe::CollisionProbe(Backend& backend, const ProbeQuestion& question)
    : backend_(backend), question_(question), collisions_(make_probe_collisions(question)) {
    result_.nothing = collisions_.nothing;
    if (!result_.nothing.empty()) {
        done_ = true;
        return;
    }
    for (const ProbedCollision& collision : collisions_.collisions) {
        tracks_.push_back({-collision.speed, 0.0, 0.0, 0});
    }
    backend_.load(collisions_.balls, collisions_.schedule, question_.settings.limit_force);
    backend_.start_history(std::min(collisions_.substeps, history_entries));
}

bool CollisionProbe::advance(std::uint32_t substeps) {
    if (done_) {
        return true;
    }
    if (waiting_) {
        const auto history = backend_.poll_history();
        if (!history) {
            return false;
        }
        waiting_ = false;
        follow(*history);
        if (ran_ == collisions_.substeps) {
            finish();
            return true;
        }
    }
    run(std::min({substeps, history_entries - recorded_, collisions_.substeps - ran_}));
    if (recorded_ == history_entries || ran_ == collisions_.substeps) {
        backend_.request_history();
        waiting_ = true;
        recorded_ = 0;
    }
    return false;
}

void CollisionProbe::run(std::uint32_t substeps) {
    const Schedule& schedule = collisions_.schedule;
    const Settings& settings = question_.settings;
    for (std::uint32_t i = 0; i < substeps; ++i) {
        backend_.run(schedule, probe_params(question_, collisions_, velocity_lag_), 0, schedule.dispatches.size());
        if (schedule.swaps_states) {
            backend_.swap_states();
        }
        velocity_lag_ =
            substep_motion(settings.integrator, 0.0, settings.dt / settings.substeps, velocity_lag_).lag_after;
        backend_.record_history();
    }
    ran_ += substeps;
    recorded_ += substeps;
}

void CollisionProbe::follow(const Bytes& history) {
    const std::vector<vec4> numbers = typed<vec4>(history);
    const std::size_t balls = collisions_.balls.positions.size();
    for (std::size_t entry = 0; (entry + 1) * 2 * balls <= numbers.size(); ++entry) {
        const vec4* x = numbers.data() + entry * 2 * balls;
        const vec4* v = x + balls;
        const auto at = [](const vec4* all, std::size_t ball) { return static_cast<double>(all[ball].x); };
        for (std::size_t i = 0; i < tracks_.size(); ++i) {
            const ProbedCollision& c = collisions_.collisions[i];
            const double distance = c.wall ? at(x, c.ball) - collisions_.wall : at(x, c.ball + 1) - at(x, c.ball);
            const bool lost = in_quarantine(x[c.ball]) || (!c.wall && in_quarantine(x[c.ball + 1]));
            const double velocity = lost     ? std::numeric_limits<double>::infinity()
                                    : c.wall ? at(v, c.ball)
                                             : at(v, c.ball + 1) - at(v, c.ball);
            Track& track = tracks_[i];
            track.pushed += velocity != track.velocity ? 1u : 0u;
            track.velocity = velocity;
            track.overlap = c.reach - distance;
            track.largest_overlap = std::max(track.largest_overlap, track.overlap);
        }
    }
}

ProbeGroup CollisionProbe::summary(std::size_t group) const {
    const std::size_t first = group * probe_phases;
    const ProbedCollision& model = collisions_.collisions[first];
    const Settings& settings = question_.settings;
    const double zeta = collisions_.damping_ratio;
    const double frequency = contact_frequency(question_, model.wall);
    const double diameter = 2.0 * question_.scene.radius;
    const double e = restitution_from_damping_ratio(zeta, settings.limit_force);
    std::vector<double> restitutions;
    std::vector<double> overlaps;
    std::vector<double> durations;
    std::vector<double> gains;
    ProbeGroup result;
    for (std::size_t i = first; i < first + probe_phases; ++i) {
        const Track& track = tracks_[i];
        const double measured = finite(track.velocity / model.speed);
        restitutions.push_back(measured);
        overlaps.push_back(finite(track.largest_overlap / diameter));
        durations.push_back(track.pushed * settings.dt / settings.substeps);
        gains.push_back(measured * measured - e * e);
        // A push that a limited force ends may leave the balls overlapping for a while: they come apart.
        result.unending += track.pushed == 0 || !(track.velocity > 0.0) ? 1u : 0u;
    }
    result.wall = model.wall;
    result.largest = group % 2 == 1;
    result.speed = model.speed;
    result.restitution = spread_of(restitutions, e);
    result.overlap = spread_of(overlaps, model.speed / frequency * largest_overlap(zeta) / diameter);
    result.duration = spread_of(durations, contact_duration(zeta, settings.limit_force) / frequency);
    result.gain = spread_of(gains, 0.0);
    return result;
}

void CollisionProbe::finish() {
    const Settings& settings = question_.settings;
    for (std::size_t group = 0; group < tracks_.size() / probe_phases; ++group) {
        result_.groups.push_back(summary(group));
    }
    result_.substeps_a_contact =
        std::numbers::pi * settings.substeps / (contact_frequency(question_, !settings.laws.contact) * settings.dt);
    result_.substeps = ran_;
    backend_.start_history(0);
    done_ = true;
}

ProbeResult run_probe(Backend& backend, const ProbeQuestion& question) {
    CollisionProbe probe(backend, question);
    while (!probe.advance(history_entries)) {
        backend.finish();
    }
    return probe.result();
}

}  // namespace ballpit::measure
