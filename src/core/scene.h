// A scene is plain data: what is in the box, which laws hold, and the settings to start with. It says
// nothing about how it is computed or drawn.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/box.h"
#include "core/layout.h"
#include "core/settings.h"
#include "core/vector.h"

namespace ballpit {

/// One ball as a scene file gives it. SI units.
struct BallSpec {
    dvec3 position{0.0};
    dvec3 velocity{0.0};
    double radius = 0.1;
    double mass = 1.0;
    std::optional<double> restitution;
    /// Of a saved moment: what its sums had left out. Else it is what position and velocity lose when rounded to
    /// single.
    std::optional<Compensation> compensation{};
    bool quarantined = false;  // of a saved moment (quarantine.h)
};

/// `count` balls put at random into `region` without touching each other, as long as they fit.
struct Fill {
    std::uint32_t count = 0;
    std::array<double, 2> radius{0.1, 0.1};  // m, uniform between the two
    double density = 1000.0;                 // kg/m^3
    double speed = 0.0;                      // m/s, the same for all, in random directions
    std::array<dvec3, 2> region{};           // m, lower and upper corner; holds whole balls
    std::uint64_t seed = 0;
};

/// The moment at which a running scene was saved: what it needs, beside the balls, to go on bit for bit.
struct Resume {
    std::uint64_t step = 0;
    std::uint32_t substep = 0;  // of this step that have run
    double time = 0.0;          // s
    double velocity_lag = 0.0;  // s (integrator.h)
    WallShift walls;
};

/// What a scene promises for its first 600 steps.
struct Bounds {
    double speed = 0.0;    // m/s, of the fastest ball
    double overlap = 0.0;  // of a pair or of a ball and a wall, in diameters of the smaller ball
    double outside = 0.0;  // m, of a centre beyond the walls
};

struct Scene {
    std::string name;
    std::string about;
    dvec3 half_extent{10.0};
    /// If not 0: with more balls than this, box and fill region widen in x and y by sqrt(balls / reference_count),
    /// so that a pile is as deep at every count.
    std::uint32_t reference_count = 0;
    Settings settings;  // settings.balls == balls.size() + fill count
    std::vector<BallSpec> balls;
    std::optional<Fill> fill;
    std::optional<Resume> resume;
    std::optional<Bounds> bounds;
};

/// Factor by which box and fill region are wider in x and y at this count; 1 or more.
double widening(const Scene& scene, std::uint32_t balls);

}  // namespace ballpit
