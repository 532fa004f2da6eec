// What the cases of extremes.h are written with.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/simulation.h"
#include "measure/energy.h"
#include "measure/extremes.h"
#include "measure/neighbours.h"
#include "measure/stability.h"

namespace ballpit::measure {

class ExtremeTrial {
public:
    explicit ExtremeTrial(const MakeBackend& make_backend) : make_backend_(make_backend) {}

    /// The scene on a backend of its own, with its own settings and seed 1.
    Simulation start(const Scene& scene) const { return {scene, scene.settings, 1, make_backend_()}; }

    void expect(bool holds, std::string found);
    /// A claim that is told only where it does not hold.
    void require(bool holds, std::string otherwise);
    /// Claims with a number; a number that is NaN never holds.
    void at_most(const std::string& what, double found, double most, std::string_view unit = "");
    void at_least(const std::string& what, double found, double least, std::string_view unit = "");
    /// Within `share` of the number that is to be expected.
    void near(const std::string& what, double found, double expected, double share, std::string_view unit = "");
    /// What the simulation has counted and warns of goes into the row; `key` must be among it.
    void expect_sign(Simulation& simulation, std::string_view key);
    /// The same, where nothing may be.
    void expect_no_sign(Simulation& simulation);
    void expect_no_sign(Simulation& simulation, std::string_view key);
    /// Into the row, without a claim.
    void note_signs(Simulation& simulation);
    void note(const ExtremeSign& sign);

    const std::vector<ExtremeClaim>& claims() const { return claims_; }
    const std::vector<ExtremeSign>& signs() const { return signs_; }

private:
    const MakeBackend& make_backend_;
    std::vector<ExtremeClaim> claims_;
    std::vector<ExtremeSign> signs_;
};

/// Four digits.
std::string digits(double value);

/// A box of this half extent along every axis with these laws (laws.h); stiffness 1000 N/m, restitution 1, no balls
/// yet.
Scene extreme_scene(std::string_view laws, double half_extent);
void put_ball(Scene& scene, const dvec3& position, const dvec3& velocity, double radius = 0.1, double mass = 1.0);
/// Balls at random in the region, as scene files have it.
void fill_region(Scene& scene, std::uint32_t count, const std::array<double, 2>& radius, double speed,
                 const dvec3& lower, const dvec3& upper);

void run_steps(Simulation& simulation, std::uint64_t steps);
/// Of the state as it is computed with.
std::uint64_t hash_of(Simulation& simulation);
Totals totals_of(Simulation& simulation);
bool all_finite(const BallState& state);
/// Of the present moment; waits for the device.
MeterRecord metered(Simulation& simulation);
/// Everything that was counted, and what the present moment is warned of (core/extremes.h).
std::vector<ExtremeSign> signs_of(Simulation& simulation);
bool has_sign(Simulation& simulation, std::string_view key);
/// The gauge with this name of the present moment; value 0 where there is none.
Gauge gauge_of(Simulation& simulation, std::string_view name);
/// What the grid finds of the touching pairs of the present moment; runs a substep. Keys and cells must be as the
/// stages promise.
NeighbourReport grid_report(ExtremeTrial& trial, Simulation& simulation);

}  // namespace ballpit::measure
