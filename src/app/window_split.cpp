#include "app/window_split.h"

#include <algorithm>

#include "app/probe_overlay.h"
#include "ui/widgets.h"

namespace ballpit::app {

namespace {

constexpr std::uint32_t most_on_gpu = 20000;
constexpr std::uint32_t most_on_cpu = 5000;
constexpr std::size_t checkpoint_budget = std::size_t{64} << 20;
constexpr double times_every_s = 0.25;

double farthest_apart(const std::vector<vec4>& a, const std::vector<vec4>& b) {
    double farthest = 0.0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        farthest = std::max(farthest, static_cast<double>(glm::distance(vec3(a[i]), vec3(b[i]))));
    }
    return farthest;
}

}  // namespace

std::uint32_t most_brute_force_balls(std::string_view backend_name) {
    return backend_name == "gpu" ? most_on_gpu : most_on_cpu;
}

std::optional<std::string> brute_force_refusal(std::uint32_t balls, bool has_contacts, std::string_view backend_name) {
    if (!has_contacts) {
        return "This scene has no contacts: there are no pairs to look for, by brute force or otherwise.";
    }
    const std::uint32_t most = most_brute_force_balls(backend_name);
    if (balls > most) {
        return "Brute force would test " + ui::grouped(std::uint64_t{balls} * (std::uint64_t{balls} - 1)) +
               " pairs in every substep: it is offered up to " + ui::grouped(most) + " balls here.";
    }
    return std::nullopt;
}

void Split::start(Session& session) {
    Simulation& left = session.simulation();
    Checkpoint checkpoint = left.checkpoint();
    checkpoint.run.settings.neighbours = NeighbourSearch::brute_force;
    stop();
    Settings settings = left.settings();
    settings.neighbours = NeighbourSearch::brute_force;
    auto right = std::make_unique<Simulation>(left.scene(), settings, left.seed(), session.twin_backend());
    right->restore(checkpoint);
    // What the substep before began with, so that both sides speak of the same one.
    for (const Slot slot : {Slot::next_positions, Slot::next_velocities}) {
        right->backend().write(slot, left.backend().read(slot));
    }
    right->backend().set_timing(true);
    simulation_ = std::move(right);
    stepper_ = std::make_unique<Stepper>(*simulation_, checkpoint_budget);
    layout_ = session.layout_changes();
    revision_ = session.revision();
}

void Split::stop() { *this = Split(); }

std::optional<std::string> Split::follow(Session& session) {
    const Simulation& left = session.simulation();
    if (auto refusal = brute_force_refusal(left.schedule().ball_count, left.features().has(Feature::contact),
                                           left.backend().name())) {
        stop();
        return refusal;
    }
    const Moment target = session.stepper().position().moment;
    const bool behind_its_start = open() && target < stepper_->timeline().start();
    if (!open() || layout_ != session.layout_changes() || behind_its_start) {
        start(session);
        return std::nullopt;
    }
    if (revision_ != session.revision()) {
        revision_ = session.revision();
        stepper_->go_to({target, 0});
    }
    brute_time_.add(simulation_->backend().take_times());
    return std::nullopt;
}

void Split::look(const measure::BufferSample* left, bool running, double now_s, double copies_a_second) {
    grid_time_.refresh(now_s);
    brute_time_.refresh(now_s);
    Backend& backend = simulation_->backend();
    // Both sides are counted as their last collide saw them.
    const Slot slot = left != nullptr && left->next_positions.empty() ? Slot::positions : Slot::next_positions;
    if (!running) {
        if (counted_revision_ != revision_ && left != nullptr) {
            counted_revision_ = revision_;
            count(read_slot<vec4>(backend, slot), simulation_->schedule());
            apart_ = farthest_apart(left->positions, sample_.positions);
        }
        return;
    }
    apart_.reset();
    counted_revision_ = 0;
    if (const auto bytes = backend.poll(Slot::next_positions)) {
        count(typed<vec4>(*bytes), simulation_->schedule());
    }
    if (now_s - asked_s_ >= 1.0 / copies_a_second) {
        asked_s_ = now_s;
        backend.request(Slot::next_positions);
    }
}

void Split::count(std::vector<vec4> positions, const Schedule& schedule) {
    sample_ = {};
    sample_.positions = std::move(positions);
    sample_.grid = schedule.grid;
    sample_.uses_grid = false;
    pairs_ = measure::found_pairs(sample_);
    counted_ = true;
}

void Split::add_to(view::Overlay& overlay, float top_overlap) const {
    append_contacts(overlay.lines, sample_, pairs_, top_overlap);
}

void Split::describe(ui::ProbeState& state, const Session& session, const measure::FoundPairs* grid_pairs) const {
    const bool grid = session.simulation().schedule().cell_count > 0;
    state.grid_side.title = grid ? "Grid" : "Brute force, too: set Neighbours to grid";
    state.grid_side.known = grid_pairs != nullptr;
    if (grid_pairs != nullptr) {
        state.grid_side.tested = grid_pairs->tested;
        state.grid_side.contacts = grid_pairs->found.size();
        state.grid_side.missed = grid_pairs->missed.size();
    }
    state.grid_side.ms_per_substep = grid_time_.ms();
    state.brute_side = {"Brute force", counted_, pairs_.tested, pairs_.found.size(), 0, brute_time_.ms()};
    state.apart = apart_;
}

void Split::MeanTime::add(std::span<const StageTimes> times) {
    for (const StageTimes& substep : times) {
        for (const double ms : substep) {
            sum_ms_ += ms;
        }
        ++substeps_;
    }
}

// Changes slowly enough to be read.
void Split::MeanTime::refresh(double now_s) {
    if (substeps_ > 0 && now_s - shown_s_ >= times_every_s) {
        ms_ = sum_ms_ / substeps_;
        sum_ms_ = 0.0;
        substeps_ = 0;
        shown_s_ = now_s;
    }
}

}  // namespace ballpit::app
