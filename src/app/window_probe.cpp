#include "app/window_probe.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "app/atomic_file.h"
#include "app/probe_legend.h"
#include "app/probe_overlay.h"
#include "core/error.h"
#include "measure/slot_table.h"

namespace ballpit::app {

namespace {

// Worked out within the frame; more than that, on a thread of its own.
constexpr std::size_t few_balls = 20000;
constexpr std::size_t few_balls_running = 3000;
constexpr std::size_t few_cells = std::size_t{1} << 18;

constexpr float usual_contacts = 12.0f;  // equal balls round one: at most

BallValue value_of(ui::BallColour colour) {
    switch (colour) {
        case ui::BallColour::slot:
            return BallValue::slot;
        case ui::BallColour::contacts:
            return BallValue::contacts;
        case ui::BallColour::radius:
            return BallValue::radius;
        default:
            return BallValue::none;
    }
}

std::string export_csv(const std::filesystem::path& path, Slot slot, const Bytes& bytes) {
    try {
        AtomicFile file(path);
        measure::write_slot_csv(file.stream(), slot, bytes);
        file.commit();
        return "Written: " + std::filesystem::absolute(path).string();
    } catch (const InputError& error) {
        return error.what();
    }
}

}  // namespace

void Probe::show_element(Slot slot, std::uint64_t element) {
    options_.buffers = true;
    options_.slot = slot;
    buffer_jump_ = {element, buffer_jump_.serial + 1};
}

std::optional<std::uint32_t> Probe::cell_of_ball(std::uint32_t ball) const {
    if (!sample_ || ball >= sample_->positions.size()) {
        return std::nullopt;
    }
    return measure::probe_ball(*sample_, ball).cell_id;
}

ProbeWants Probe::wants(ui::BallColour colour) const {
    return {options_.contacts || options_.split, options_.cells, options_.cell_order, value_of(colour)};
}

bool Probe::needs_sample(ui::BallColour colour, bool ball_selected) const {
    return wants(colour).any() || (options_.follow && ball_selected);
}

bool Probe::needs_cells(ui::BallColour colour, bool ball_selected) const {
    return needs_sample(colour, ball_selected) || options_.slice || options_.buffers;
}

void Probe::want(Inspector& inspector, ui::BallColour colour, bool ball_selected) const {
    inspector.set_rate(options_.copies_a_second);
    if (needs_sample(colour, ball_selected)) {
        for (const Slot slot : {Slot::positions, Slot::next_positions, Slot::keys, Slot::cell_ranges}) {
            inspector.want(slot);
        }
        if (options_.follow && ball_selected) {
            inspector.want(Slot::velocities);
            inspector.want(Slot::next_velocities);
        }
    }
    if (options_.buffers) {
        inspector.want(options_.slot);
    }
}

void Probe::update(Session& session, const Inspector& inspector, const ui::Inspection& inspection,
                   ui::BallColour colour, bool running) {
    if (!needs_sample(colour, inspection.ball.has_value())) {
        sample_.reset();
        sample_revision_ = 0;
    } else {
        take_sample(session, inspector, running);
    }
    follow_.reset();
    if (sample_ && options_.follow && inspection.ball && *inspection.ball < sample_->positions.size()) {
        follow_ = measure::probe_ball(*sample_, *inspection.ball);
    }
    take_work(wants(colour), running);
    if (colour != ui::BallColour::difference) {
        difference_revision_ = 0;  // another colour has taken its place
    }
    if (auto message = export_.take()) {
        message_ = std::move(*message);
    }
}

void Probe::take_sample(Session& session, const Inspector& inspector, bool running) {
    SlotBytes copies;
    for (std::size_t i = 0; i < slot_count; ++i) {
        copies.slots[i] = inspector.bytes(static_cast<Slot>(i));
    }
    const std::uint64_t revision = inspector.revision(Slot::positions);
    const auto of_another = [&](Slot slot) { return copies[slot] != nullptr && inspector.revision(slot) != revision; };
    const bool mixed = of_another(Slot::next_positions) || of_another(Slot::keys) || of_another(Slot::cell_ranges);
    const bool velocities_new = sample_ && sample_->velocities.empty() && copies[Slot::velocities] != nullptr;
    if (copies[Slot::positions] == nullptr) {
        sample_.reset();  // other buffers
        return;
    }
    if (mixed || (sample_ && revision == sample_revision_ && !velocities_new)) {
        return;
    }
    Stepper& stepper = session.stepper();
    const std::uint32_t dispatch = running ? 0 : stepper.position().dispatch;
    auto sample = make_sample(copies, stepper.schedule(), session.simulation().params(), dispatch);
    within_substep_ = dispatch > 0 || stepper.schedule().in_place;
    sample_revision_ = revision;
    sample_ = sample ? std::make_shared<const measure::BufferSample>(std::move(*sample)) : nullptr;
}

void Probe::take_work(const ProbeWants& wants, bool running) {
    if (auto arrived = background_.take()) {
        accept(std::move(arrived->work), std::move(arrived->sample));
    }
    if (!sample_ || !wants.any()) {
        work_ = {};
        work_sample_.reset();
        pairs_known_ = false;
        lines_.clear();
        value_shown_ = BallValue::none;
        return;
    }
    if ((work_sample_ == sample_ && work_.wants == wants) || background_.busy()) {
        return;
    }
    const bool few = sample_->positions.size() <= (running ? few_balls_running : few_balls) &&
                     sample_->cell_ranges.size() <= few_cells;
    if (few) {
        accept(work_out(*sample_, wants), sample_);
    } else {
        background_.start([sample = sample_, wants] { return Arrived{work_out(*sample, wants), sample}; });
    }
}

void Probe::accept(ProbeWork work, std::shared_ptr<const measure::BufferSample> sample) {
    if (!sample_ || sample->positions.size() != sample_->positions.size() ||
        sample->cell_ranges.size() != sample_->cell_ranges.size()) {
        return;  // of buffers that are gone
    }
    work_ = std::move(work);
    work_sample_ = std::move(sample);
    pairs_known_ = work_.wants.pairs;
    draw_lines();
    set_values();
}

void Probe::draw_lines() {
    lines_.clear();
    if (work_.wants.pairs && options_.contacts) {
        append_contacts(lines_, *work_sample_, work_.pairs, top_overlap());
    }
    if (work_.wants.pairs) {
        append_missed_pairs(lines_, *work_sample_, work_.pairs);
    }
}

void Probe::set_values() {
    value_shown_ = work_.values.empty() ? BallValue::none : work_.wants.value;
    if (value_shown_ == BallValue::none) {
        return;
    }
    upload(work_.values);
    const auto [low, high] = std::ranges::minmax(work_.values);
    value_low_ = value_shown_ == BallValue::radius ? low : 0.0f;
    value_high_ = value_shown_ == BallValue::contacts ? std::max(usual_contacts, high)
                  : value_shown_ == BallValue::slot   ? static_cast<float>(work_.values.size())
                                                      : high;
}

void Probe::upload(std::span<const float> values) {
    const auto bytes = std::as_bytes(values);
    if (value_buffer_.size() < bytes.size()) {
        value_buffer_ = gl::Buffer("ball values", bytes.size(), GL_STREAM_DRAW);
    }
    value_buffer_.write(bytes);
}

void Probe::take_differences(const ui::LiveCheckState& check, std::uint32_t balls, std::uint64_t revision) {
    const ui::StageCheck& collide = check.stages[static_cast<std::size_t>(Stage::collide)];
    if (!collide.ran || !collide.compared || balls == 0) {
        difference_ = Difference::not_checked;
        difference_revision_ = 0;
        return;
    }
    if (difference_revision_ == revision) {
        return;
    }
    difference_revision_ = revision;
    std::vector<float> values(balls, 0.0f);
    for (const ui::SlotDifference& slot : collide.differences) {
        const bool velocities = slot.slot == Slot::next_velocities || slot.slot == Slot::velocities;
        if (velocities && slot.gpu.size() == balls * sizeof(vec4)) {
            values = measure::difference_values(typed<vec4>(slot.gpu), typed<vec4>(slot.cpu));
        }
    }
    upload(values);
    value_low_ = 0.0f;
    value_high_ = round_up(std::ranges::max(values));
    difference_ = value_high_ > 0.0f ? Difference::some : Difference::none;
}

const gl::Buffer* Probe::values(ui::BallColour colour) const {
    if (colour == ui::BallColour::difference) {
        return difference_ == Difference::not_checked ? nullptr : &value_buffer_;
    }
    return value_shown_ != BallValue::none && value_shown_ == value_of(colour) ? &value_buffer_ : nullptr;
}

float Probe::top_overlap() const { return round_up(work_.usual_overlap); }

void Probe::add_to(view::Overlay& overlay, const ui::Inspection& inspection, const Grid& grid) const {
    overlay.lines.insert(overlay.lines.end(), lines_.begin(), lines_.end());
    if (follow_) {
        append_followed(overlay, sample_->grid, *follow_);
    }
    if (options_.cells && inspection.cell && work_sample_) {
        append_cell_balls(overlay, *work_sample_, *inspection.cell);
    }
    if (options_.fade && (follow_ || (options_.cells && inspection.cell))) {
        overlay.fade_others = 0.8f;
    } else if (options_.fade && options_.contacts) {
        overlay.fade_others = 0.75f;
    }
    overlay.arrow_seconds = options_.arrows ? options_.arrow_seconds : 0.0f;
    if (options_.slice) {
        const std::uint32_t last = std::max(grid.cells[options_.slice_axis], 1u) - 1;
        overlay.slice = view::GridSlice{options_.slice_axis, std::min(options_.slice_layer, last), options_.slice_cut};
    }
}

void Probe::describe(ui::ProbeState& state, const Session& session, const ui::Inspection& inspection,
                     const Setting& setting) {
    const Schedule& schedule = session.simulation().schedule();
    state.options = options_;
    state.ball_count = schedule.ball_count;
    state.has_contacts = schedule.features.has(Feature::contact);
    state.uses_grid = schedule.cell_count > 0;
    state.grid_cells = schedule.grid.cells;
    state.within_substep = within_substep_;
    state.ball = inspection.ball;
    state.cell = inspection.cell;
    state.sample = work_sample_ ? work_sample_.get() : sample_.get();
    state.follow = follow_ ? &*follow_ : nullptr;
    state.cells = work_.cells;
    state.cell_jump = cell_jump_;
    state.buffer = inspection.slot(options_.slot).bytes;
    state.buffer_jump = buffer_jump_;
    state.age_s = inspection.slot(options_.slot).age_s;
    state.cost_ms = work_.ms;
    state.working = working();
    legends_ = make_legends({setting.colour, options_, work_sample_ ? &work_ : nullptr, follow_.has_value(),
                             setting.occupancy, setting.top_count, setting.top_speed, value_low_, value_high_,
                             top_overlap(), difference_ != Difference::not_checked});
    state.legends = legends_;
}

void Probe::start_export(Slot slot, const Inspector& inspector, const Session& session) {
    const Bytes* bytes = inspector.bytes(slot);
    if (bytes == nullptr) {
        return;
    }
    if (export_.busy()) {
        message_ = "The export before is still being written.";
        return;
    }
    const std::filesystem::path path = "ballpit_step" + std::to_string(session.simulation().step_count()) + "_" +
                                       std::string(slot_name(slot)) + ".csv";
    export_.start([path, slot, copy = *bytes] { return export_csv(path, slot, copy); });
}

std::string Probe::take_message() { return std::exchange(message_, {}); }

}  // namespace ballpit::app
