// What computes a substep: the GPU, or the CPU mirror. Both walk the same schedule over the same slots, so
// whoever holds a Backend can step, look into every buffer and compare, without knowing which one it is.
#pragma once

#include <cstddef>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/ball_state.h"
#include "core/meter.h"
#include "core/schedule.h"
#include "core/storage_limits.h"
#include "core/substep_params.h"

namespace ballpit {

using Bytes = std::vector<std::byte>;

/// Milliseconds that one run of a whole substep took, by stage; a stage that did not run has 0.
using StageTimes = std::array<double, stage_count>;

/// A copy of the state that a backend keeps where it computes: positions, velocities, compensations, damping
/// ratios and status.
class SavedState {
public:
    explicit SavedState(std::uint32_t ball_count) : ball_count_(ball_count) {}
    SavedState(const SavedState&) = delete;
    SavedState& operator=(const SavedState&) = delete;
    virtual ~SavedState() = default;

    std::uint32_t ball_count() const { return ball_count_; }
    virtual std::size_t bytes() const = 0;

private:
    std::uint32_t ball_count_;
};

/// The hash of the state that was current when it was asked for.
struct TaggedHash {
    std::uint64_t tag;
    std::uint64_t hash;
};

class Backend {
public:
    Backend() = default;
    Backend(const Backend&) = delete;
    Backend& operator=(const Backend&) = delete;
    virtual ~Backend() = default;

    virtual std::string_view name() const = 0;  // "gpu" or "cpu"
    virtual std::string device() const = 0;     // renderer or processor
    virtual std::string driver() const = 0;     // version text

    /// What the device has room for (storage_limits.h).
    virtual StorageLimits storage_limits() const { return {}; }

    /// Makes room for the schedule's slots and loads the state (`limit_force` turns restitutions into damping
    /// ratios). Throws NoRoom when the device has none; the balls that were there are then still there.
    virtual void load(const BallState& state, const Schedule& schedule, bool limit_force) = 0;

    /// Makes room for another schedule over the same balls (another grid, another sort).
    virtual void reschedule(const Schedule& schedule) = 0;

    /// Runs dispatches [first, last) of the schedule.
    virtual void run(const Schedule& schedule, const SubstepParams<double>& params, std::size_t first,
                     std::size_t last) = 0;

    /// Ends a substep that swaps_states: what collide wrote becomes the state.
    virtual void swap_states() = 0;

    /// Whether it runs substeps that keep the order (schedule.h), and hides from everybody else that the state is not
    /// in the order of ball ids: whoever looks at positions or velocities finds them where they belong.
    virtual bool keeps_order() const { return false; }
    /// Whether the last substep kept the order, and nothing has put the state elsewhere since: then a substep that uses
    /// the same grid again may follow.
    virtual bool is_in_order() const { return false; }

    /// Copies the state, at the start of a substep, without waiting for the device.
    virtual std::unique_ptr<SavedState> save() = 0;
    /// Puts a state of this backend back, with room for the schedule's slots.
    virtual void restore(const SavedState& state, const Schedule& schedule) = 0;

    /// Asks for the hash of the state (ball_state.h) without waiting; take_hashes() has those that are there, in
    /// the order of asking.
    virtual void request_hash(std::uint64_t tag) = 0;
    virtual std::vector<TaggedHash> take_hashes() = 0;

    /// Asks for what is to be metered of the substep's start, without waiting; take_readings() has those that are
    /// there, in the order of asking. Where balls touch each other: between the last dispatch and swap_states(). In
    /// place: before the first dispatch.
    virtual void request_reading(std::uint64_t tag, const Schedule& schedule, const SubstepParams<double>& params,
                                 const Synchronisation& synchronisation) = 0;
    virtual std::vector<TaggedReading> take_readings() = 0;
    /// ms that each reading took the device, as far as it is known; late as well.
    virtual std::vector<double> take_reading_times() = 0;

    /// The bytes of a slot, in the layout of layout.h. Waits for the device.
    virtual Bytes read(Slot slot) = 0;
    /// Overwrites the start of a slot.
    virtual void write(Slot slot, std::span<const std::byte> bytes) = 0;

    /// Asks for a copy of a slot as it is now, without waiting; poll() has it some frames later. A request
    /// while another one for the same slot is under way is ignored.
    virtual void request(Slot slot) = 0;
    virtual std::optional<Bytes> poll(Slot slot) = 0;

    /// A history of few balls: makes room on the device for `entries` copies of positions and velocities (0: gives it
    /// back) and forgets what was there. For the balls that are loaded; load another count, and start it again.
    virtual void start_history(std::uint32_t entries) = 0;
    /// Copies positions and velocities, as they are now, to the next place of the history; nobody waits.
    virtual void record_history() = 0;
    /// Asks for what was recorded, without waiting, and begins again at the first place; poll_history() has it some
    /// frames later: for each entry, a vec4 a ball of positions, then of velocities. Ignored while one is under way.
    virtual void request_history() = 0;
    virtual std::optional<Bytes> poll_history() = 0;

    /// Whether whole-substep runs are timed. Results come late: take_times() has those that are there.
    virtual void set_timing(bool on) = 0;
    virtual std::vector<StageTimes> take_times() = 0;

    /// Waits until everything that was run is done.
    virtual void finish() = 0;
};

/// The bytes of a slot as typed elements.
template <class T>
std::vector<T> typed(std::span<const std::byte> bytes) {
    std::vector<T> elements(bytes.size() / sizeof(T));
    if (!elements.empty()) {
        std::memcpy(elements.data(), bytes.data(), elements.size() * sizeof(T));
    }
    return elements;
}

template <class T>
std::vector<T> read_slot(Backend& backend, Slot slot) {
    return typed<T>(backend.read(slot));
}

}  // namespace ballpit
