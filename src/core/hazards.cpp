#include "core/hazards.h"

#include <numeric>
#include <utility>

namespace ballpit {

Hazards::Hazards() { std::iota(buffers_.begin(), buffers_.end(), std::size_t{0}); }

void Hazards::swap(Slot a, Slot b) {
    std::swap(buffers_[static_cast<std::size_t>(a)], buffers_[static_cast<std::size_t>(b)]);
}

void Hazards::swap_states() {
    swap(Slot::positions, Slot::next_positions);
    swap(Slot::velocities, Slot::next_velocities);
}

void Hazards::swap_copies() {
    swap(Slot::next_positions, Slot::sorted_positions);
    swap(Slot::next_velocities, Slot::sorted_velocities);
}

Uses Hazards::before(const Dispatch& dispatch) const {
    Uses uses = 0;
    for (const Slot slot : dispatch.reads) {
        uses |= before_use(slot, Use::storage);
    }
    for (const Slot slot : dispatch.writes) {
        uses |= before_use(slot, Use::storage) | (read_[physical(slot)] ? only(Use::storage) : 0u);
    }
    return uses;
}

void Hazards::issued(Uses uses) {
    for (Uses& pending : pending_) {
        pending &= ~uses;
    }
    if ((uses & only(Use::storage)) != 0) {
        read_ = {};
    }
}

void Hazards::ran(const Dispatch& dispatch) {
    for (const Slot slot : dispatch.reads) {
        read_[physical(slot)] = true;
    }
    for (const Slot slot : dispatch.writes) {
        pending_[physical(slot)] = all_uses;
    }
}

}  // namespace ballpit
