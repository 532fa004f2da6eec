#include "measure/energy_balance.h"

namespace ballpit::measure {

namespace {

void take_energies(Balance& balance, const MeterRecord& record, double potential_before) {
    balance.step = record.step;
    balance.substep = record.substep;
    balance.time = record.time;
    balance.kinetic = record.reading.kinetic;
    balance.potential += record.reading.potential - potential_before;
    balance.elastic = record.reading.elastic;
}

}  // namespace

const Balance& EnergyBalance::add(const MeterRecord& record) {
    if (!balance_ || record.run != last_.run || record.time < last_.time) {
        balance_.emplace();
        take_energies(*balance_, record, record.reading.potential);
        balance_->base_time = record.time;
        balance_->start = record.reading.kinetic + record.reading.elastic;
    } else {
        const double half = 0.5 * (record.time - last_.time);
        const MeterReading& a = last_.reading;
        const MeterReading& b = record.reading;
        balance_->drag_heat += half * (last_.drag_heat() + record.drag_heat());
        balance_->contact_heat += half * (a.contact_heat + b.contact_heat);
        balance_->wall_heat += half * (a.wall_heat + b.wall_heat);
        balance_->work += half * (a.wall_work + a.hand_work + b.wall_work + b.hand_work);
        take_energies(*balance_, record, a.potential);
    }
    last_ = record;
    return *balance_;
}

void BalanceSeries::add(const Balance& balance) {
    if (!points_.empty() && (points_.back().base_time != balance.base_time || points_.back().time > balance.time)) {
        clear();
    }
    if (!points_.empty() && ++skipped_ < stride_) {
        return;
    }
    skipped_ = 0;
    points_.push_back(balance);
    if (points_.size() == capacity) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < points_.size(); i += 2) {
            points_[kept++] = points_[i];
        }
        points_.resize(kept);
        stride_ *= 2;
    }
}

void BalanceSeries::clear() {
    points_.clear();
    stride_ = 1;
    skipped_ = 0;
}

}  // namespace ballpit::measure
