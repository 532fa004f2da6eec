// Copies of the buffers for whoever looks into them. Paused, a copy is read when the position changes, and may wait for
// the device; while the simulation runs nothing ever waits: copies are asked for at a stated rate, and shown when all
// of one moment have arrived. What nobody wants in a frame is neither read nor kept.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "app/window_session.h"
#include "core/backend.h"
#include "ui/inspection.h"

namespace ballpit::app {

class Inspector {
public:
    /// Copies a second while the simulation runs.
    void set_rate(double copies_a_second) { copies_a_second_ = copies_a_second; }

    /// To be said in every frame in which the slot is looked at, before update().
    void want(Slot slot) { wants_[index(slot)].panel = true; }
    /// The same for who does not need it now: never waits, not even while paused.
    void want_late(Slot slot) { wants_[index(slot)].late = true; }
    /// The keys as they were before the sort pass that ran last.
    void want_keys_before() { wants_keys_before_ = true; }

    /// Once a frame, after the simulation has run.
    void update(Session& session, bool running, double now_s);

    /// Null where there is no copy.
    const Bytes* bytes(Slot slot) const;
    /// Another number: another copy.
    std::uint64_t serial(Slot slot) const { return copies_[index(slot)].serial; }
    /// Session::revision() that the copy is of.
    std::uint64_t revision(Slot slot) const { return copies_[index(slot)].revision; }
    /// Whether a copy is still to come.
    bool waiting() const { return waiting_; }

    /// Empty where no sort pass ran last, or nobody wants them.
    std::span<const std::byte> keys_before() const {
        return keys_before_ ? std::span<const std::byte>(*keys_before_) : std::span<const std::byte>();
    }
    /// What panels read of it. The spans hold until the next update().
    void describe(ui::Inspection& inspection, double now_s) const;

private:
    struct Want {
        bool panel = false;
        bool late = false;
    };
    struct Copy {
        Bytes bytes;
        std::uint64_t serial = 0;
        std::uint64_t revision = 0;
        double taken_s = 0.0;
        bool there = false;
    };
    // Slots asked for in one frame, hence of one moment; shown when all are there.
    struct Batch {
        std::array<bool, slot_count> slots{};
        std::array<std::optional<Bytes>, slot_count> arrived;
        std::uint64_t revision = 0;
        double asked_s = 0.0;
    };

    bool wants_what_is_left() const;
    static std::size_t index(Slot slot) { return static_cast<std::size_t>(slot); }
    bool fresh(std::size_t slot, std::uint64_t revision) const;
    void keep(std::size_t slot, Bytes bytes, std::uint64_t revision, double now_s);
    void forget_unwanted();
    void poll(Backend& backend, double now_s);
    void ask(Backend& backend, std::uint64_t revision, bool running, double now_s);
    void read_now(Session& session, double now_s);
    void read_keys_before(Session& session);

    std::array<Want, slot_count> wants_{};
    std::array<Copy, slot_count> copies_{};
    std::optional<Batch> batch_;
    std::uint64_t copies_made_ = 0;
    std::uint64_t layout_ = 0;
    double copies_a_second_ = 5.0;
    double panels_asked_s_ = -1.0;
    bool wants_keys_before_ = false;
    std::optional<Bytes> keys_before_;
    std::uint64_t keys_before_revision_ = 0;
    std::optional<Position> keys_position_;  // of the copy of the keys, where it was read while paused
    bool waiting_ = false;
    double read_ms_ = 0.0;
};

}  // namespace ballpit::app
