#include "core/meter.h"

#include <cassert>

#include "core/layout.h"

namespace ballpit {

MeterReading reading_of(std::span<const double> values) {
    assert(values.size() == METER_VALUES);
    const auto at = [values](std::size_t place) { return values[place]; };
    const auto vector_at = [at](std::size_t place) { return dvec3(at(place), at(place + 1), at(place + 2)); };
    MeterReading reading;
    reading.kinetic = at(METER_KINETIC);
    reading.potential = at(METER_POTENTIAL);
    reading.elastic = at(METER_ELASTIC);
    reading.contact_heat = at(METER_CONTACT_HEAT);
    reading.wall_heat = at(METER_WALL_HEAT);
    reading.wall_work = at(METER_WALL_WORK);
    reading.hand_work = at(METER_HAND_WORK);
    reading.momentum = vector_at(METER_MOMENTUM);
    reading.angular_momentum = vector_at(METER_ANGULAR_MOMENTUM);
    reading.overlap_shares = at(METER_OVERLAP_SHARES);
    reading.contact_ends = at(METER_CONTACT_ENDS);
    reading.wall_contacts = at(METER_WALL_CONTACTS);
    reading.floor_force = at(METER_FLOOR_FORCE);
    reading.mass = at(METER_MASS);
    reading.max_overlap = at(METER_OVERLAP);
    reading.max_overlap_share = at(METER_OVERLAP_SHARE);
    reading.max_speed = at(METER_SPEED);
    reading.max_stiffness = at(METER_STIFFNESS);
    reading.max_speed_share = at(METER_SPEED_SHARE);
    reading.max_lightness = at(METER_LIGHTNESS);
    reading.max_damping = at(METER_DAMPING);
    return reading;
}

std::uint64_t MeterQueue::add(const MeterRecord& moment) {
    waiting_.emplace_back(next_tag_, moment);
    return next_tag_++;
}

std::vector<MeterRecord> MeterQueue::match(std::span<const TaggedReading> readings) {
    std::vector<MeterRecord> records;
    for (const TaggedReading& reading : readings) {
        while (!waiting_.empty() && waiting_.front().first < reading.tag) {
            waiting_.pop_front();
        }
        if (!waiting_.empty() && waiting_.front().first == reading.tag) {
            records.push_back(waiting_.front().second);
            records.back().reading = reading.reading;
            waiting_.pop_front();
        }
    }
    return records;
}

Synchronisation synchronisation_of(const SubstepMotion& motion, double drag, double velocity_lag, bool in_place) {
    if (velocity_lag == 0.0) {
        return {};
    }
    const Kick wanted = synchronising_motion(drag, velocity_lag).first;
    if (in_place) {
        return {wanted.decay, 0.0, wanted.gain};
    }
    // Both kicks of the substep are one: v' = decay v + gain a, which gives a, and with it the kick that is wanted.
    const double decay = motion.first.decay * motion.second.decay;
    const double gain = motion.first.gain * motion.second.decay + motion.second.gain;
    const double share = wanted.gain / gain;
    return {wanted.decay - share * decay, share, 0.0};
}

}  // namespace ballpit
