// From a share code back to the run that it holds: the scene, and what was done to it, done again at the same moments.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "app/gallery.h"
#include "app/share_code.h"
#include "core/stepper.h"

namespace ballpit::app {

struct SharedScene {
    Scene scene;
    Settings settings;  // at the start
    bool same = true;   // false: the gallery has another scene of that name
};

/// Throws InputError: a scene that the gallery does not have, or one that cannot be read; settings out of range.
SharedScene shared_scene(const SharedCode& code, std::span<const SceneEntry> gallery);

/// Runs to the moment of a code, a slice at a time, so that a window can go on drawing.
class Replay {
public:
    Replay(std::vector<SharedChange> changes, const Moment& substep, std::uint32_t ran)
        : changes_(std::move(changes)), substep_(substep), ran_(ran) {}

    /// Runs for about this long (s), at least one step; true once it has arrived. The stepper's simulation is the one
    /// that the code's scene was loaded into. Throws what a change throws that is refused.
    bool advance(Stepper& stepper, Simulation& simulation, double seconds);

    const Moment& goal() const { return substep_; }

private:
    std::vector<SharedChange> changes_;
    std::size_t next_ = 0;  // of the changes
    Moment substep_;
    std::uint32_t ran_;
};

/// The hash of the state at the start of the present step; waits for the device.
std::optional<std::uint64_t> awaited_hash(Stepper& stepper, Simulation& simulation);

}  // namespace ballpit::app
