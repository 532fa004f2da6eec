// Where the energy went: heats and work add up over a run of records, and what they do not explain is what the
// integrator made (+) or ate (-).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/meter.h"

namespace ballpit::measure {

/// J since the base, the first record of an uninterrupted run (MeterRecord::run).
struct Balance {
    std::uint64_t step = 0;
    std::uint32_t substep = 0;
    double time = 0.0;       // s
    double base_time = 0.0;  // s, of the base
    double kinetic = 0.0;    // now
    double potential = 0.0;  // now, less that of the base
    double elastic = 0.0;    // now
    double drag_heat = 0.0;
    double contact_heat = 0.0;
    double wall_heat = 0.0;
    double work = 0.0;   // that moving walls and the hand have put in
    double start = 0.0;  // kinetic and elastic energy of the base
    /// Energy now - energy at the base + heats - work.
    double unexplained() const {
        return kinetic + potential + elastic - start + drag_heat + contact_heat + wall_heat - work;
    }
};

/// Powers are integrated by the trapezoid rule between one record and the next, in double. With leapfrog and velocity
/// Verlet that is the very work of the forces on the velocities that they kick, but for the kicks at both ends.
class EnergyBalance {
public:
    /// Balance at this record, which goes on from the one before where both are of the same run and time does not run
    /// back; otherwise it is a new base.
    const Balance& add(const MeterRecord& record);
    /// Nothing before the first record.
    const std::optional<Balance>& balance() const { return balance_; }
    const MeterRecord& last() const { return last_; }
    void clear() { balance_.reset(); }

private:
    std::optional<Balance> balance_;
    MeterRecord last_;
};

/// Balances since one base, in the order of time and few enough to draw: when there are too many, every other one goes.
class BalanceSeries {
public:
    static constexpr std::size_t capacity = 1024;

    /// Another base begins anew.
    void add(const Balance& balance);
    const std::vector<Balance>& points() const { return points_; }
    void clear();

private:
    std::vector<Balance> points_;
    std::uint64_t stride_ = 1;  // of those that are added, every how many-th is kept
    std::uint64_t skipped_ = 0;
};

}  // namespace ballpit::measure
