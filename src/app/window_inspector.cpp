#include "app/window_inspector.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/ledger.h"
#include "core/stopwatch.h"

namespace ballpit::app {

namespace {

constexpr double given_up_s = 1.0;  // a load on the device cancels copies that were on their way

bool is_sort_pass(const Schedule& schedule, const Position& position) {
    return position.dispatch > 0 && schedule.dispatches[position.dispatch - 1].stage == Stage::bitonic_sort;
}

}  // namespace

bool Inspector::fresh(std::size_t slot, std::uint64_t revision) const {
    return copies_[slot].there && copies_[slot].revision == revision;
}

void Inspector::keep(std::size_t slot, Bytes bytes, std::uint64_t revision, double now_s) {
    Copy& copy = copies_[slot];
    if (copy.there && copy.revision > revision) {
        return;  // overtaken by one that was read at once
    }
    copy = {std::move(bytes), ++copies_made_, revision, now_s, true};
}

void Inspector::forget_unwanted() {
    for (std::size_t i = 0; i < slot_count; ++i) {
        if (!wants_[i].panel && !wants_[i].late) {
            copies_[i] = {};
        }
    }
    if (!wants_keys_before_) {
        keys_before_.reset();
    }
}

// What a substep leaves behind for nobody but itself, and one that keeps the order leaves otherwise.
bool Inspector::wants_what_is_left() const {
    constexpr std::array left = {Slot::next_positions,    Slot::next_velocities, Slot::sorted_positions,
                                 Slot::sorted_velocities, Slot::tickets,         Slot::scattered_keys,
                                 Slot::tile_counts,       Slot::origins};
    return std::ranges::any_of(left,
                               [this](Slot slot) { return wants_[index(slot)].panel || wants_[index(slot)].late; });
}

void Inspector::update(Session& session, bool running, double now_s) {
    if (layout_ != session.layout_changes()) {
        layout_ = session.layout_changes();
        copies_ = {};
        batch_.reset();
        keys_before_.reset();
        keys_position_.reset();
    }
    forget_unwanted();
    session.stepper().set_watched(!running || wants_what_is_left());
    if (!running) {
        read_now(session, now_s);
    }
    Backend& backend = session.simulation().backend();
    const auto bytes = bytes_of(session.simulation().schedule());
    for (std::size_t i = 0; i < slot_count; ++i) {
        const bool room = bytes[i] > 0;
        wants_[i] = {wants_[i].panel && room, wants_[i].late && room};
    }
    poll(backend, now_s);
    ask(backend, session.revision(), running, now_s);
    wants_ = {};
    wants_keys_before_ = false;
}

void Inspector::poll(Backend& backend, double now_s) {
    if (!batch_) {
        return;
    }
    bool complete = true;
    for (std::size_t i = 0; i < slot_count; ++i) {
        if (batch_->slots[i] && !batch_->arrived[i]) {
            batch_->arrived[i] = backend.poll(static_cast<Slot>(i));
            complete = complete && batch_->arrived[i].has_value();
        }
    }
    if (complete) {
        for (std::size_t i = 0; i < slot_count; ++i) {
            if (batch_->slots[i]) {
                keep(i, std::move(*batch_->arrived[i]), batch_->revision, batch_->asked_s);
            }
        }
        batch_.reset();
    } else if (now_s - batch_->asked_s > given_up_s) {
        batch_.reset();
    }
}

void Inspector::ask(Backend& backend, std::uint64_t revision, bool running, double now_s) {
    const bool panels_due = now_s - panels_asked_s_ >= 1.0 / copies_a_second_;
    Batch next;
    waiting_ = false;
    bool any = false;
    for (std::size_t i = 0; i < slot_count; ++i) {
        const bool stale = (wants_[i].late || (wants_[i].panel && running)) && !fresh(i, revision);
        waiting_ = waiting_ || stale;
        // The status is small and must not be late; the rest may be large.
        next.slots[i] = stale && (panels_due || i == index(Slot::status));
        any = any || next.slots[i];
    }
    if (batch_ || !any) {
        return;
    }
    for (std::size_t i = 0; i < slot_count; ++i) {
        if (next.slots[i]) {
            backend.request(static_cast<Slot>(i));
        }
    }
    next.revision = revision;
    next.asked_s = now_s;
    panels_asked_s_ = panels_due ? now_s : panels_asked_s_;
    batch_ = std::move(next);
}

void Inspector::read_now(Session& session, double now_s) {
    const auto start = std::chrono::steady_clock::now();
    bool read = false;
    if (wants_keys_before_ && keys_before_revision_ != session.revision()) {
        read_keys_before(session);
        read = true;
    }
    Backend& backend = session.simulation().backend();
    for (std::size_t i = 0; i < slot_count; ++i) {
        if (wants_[i].panel && !fresh(i, session.revision())) {
            keep(i, backend.read(static_cast<Slot>(i)), session.revision(), now_s);
            read = true;
        }
    }
    if (wants_[index(Slot::keys)].panel) {
        keys_position_ = session.stepper().position();
    }
    if (read) {
        read_ms_ = milliseconds_since(start);
    }
}

// One pass forth from the copy that is there is the usual case; from anywhere else: one dispatch back, read, and forth
// again, which gives the same bytes.
void Inspector::read_keys_before(Session& session) {
    Stepper& stepper = session.stepper();
    const Position now = stepper.position();
    keys_before_revision_ = session.revision();
    const auto last = std::exchange(keys_position_, std::nullopt);
    keys_before_.reset();
    if (!is_sort_pass(stepper.schedule(), now)) {
        return;
    }
    const Position before{now.moment, now.dispatch - 1};
    Copy& keys = copies_[index(Slot::keys)];
    if (keys.there && last == before && keys.revision + 1 == session.revision()) {
        keys_before_ = keys.bytes;
        return;
    }
    stepper.go_to(before);
    keys_before_ = session.simulation().backend().read(Slot::keys);
    stepper.go_to(now);
}

const Bytes* Inspector::bytes(Slot slot) const {
    const Copy& copy = copies_[index(slot)];
    return copy.there ? &copy.bytes : nullptr;
}

void Inspector::describe(ui::Inspection& inspection, double now_s) const {
    for (std::size_t i = 0; i < slot_count; ++i) {
        const Copy& copy = copies_[i];
        inspection.slots[i] = {};
        if (copy.there) {
            inspection.slots[i] = {copy.bytes, copy.revision, std::max(0.0, now_s - copy.taken_s)};
            inspection.age_s = std::max(inspection.age_s, inspection.slots[i].age_s);
        }
    }
    inspection.keys_before = keys_before();
    inspection.read_ms = read_ms_;
}

}  // namespace ballpit::app
