#include "core/hazards.h"

namespace ballpit {

std::size_t Hazards::physical(Slot slot) const {
    if (swapped_) {
        switch (slot) {
            case Slot::positions:
                return static_cast<std::size_t>(Slot::next_positions);
            case Slot::velocities:
                return static_cast<std::size_t>(Slot::next_velocities);
            case Slot::next_positions:
                return static_cast<std::size_t>(Slot::positions);
            case Slot::next_velocities:
                return static_cast<std::size_t>(Slot::velocities);
            default:
                break;
        }
    }
    return static_cast<std::size_t>(slot);
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
