// Mirror of glsl/put_back.comp: from the order that is kept back to that of the balls' ids.
#pragma once

#include <span>

#include "core/layout.h"
#include "core/vector.h"

namespace ballpit::cpu {

/// values[keys[slot].ball_id] = kept[slot]: all three as long as there are balls.
template <class T>
void put_back(std::span<const Key> keys, std::span<const T> kept, std::span<T> values) {
    for (std::size_t slot = 0; slot < keys.size(); ++slot) {
        if (keys[slot].ball_id < values.size()) {
            values[keys[slot].ball_id] = kept[slot];
        }
    }
}

/// The other way: kept[slot] = values[keys[slot].ball_id].
template <class T>
void put_in_order(std::span<const Key> keys, std::span<const T> values, std::span<T> kept) {
    for (std::size_t slot = 0; slot < keys.size(); ++slot) {
        if (keys[slot].ball_id < values.size()) {
            kept[slot] = values[keys[slot].ball_id];
        }
    }
}

}  // namespace ballpit::cpu
