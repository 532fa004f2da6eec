// Up to three passes of the bitonic network in the registers of one thread: of the eight slots that three passes
// connect, no other slot's key is compared with any.

// Puts the keys of two slots in order, the lower slot first.
void compare_exchange(inout Key lower, inout Key upper, uint lower_slot, uint k) {
    bool ascending = (lower_slot & k) == 0u;   // where k lies among the eight, pairs differ in it
    if (key_less(upper, lower) == ascending) {
        Key kept = lower;
        lower = upper;
        upper = kept;
    }
}

// The number of a thread with a 0 inserted at each of the three bits from `stride` on: its first slot.
uint first_of_eight(uint thread, uint stride) {
    return (thread & ~(stride - 1u)) * STRIDE_KEYS + (thread & (stride - 1u));
}

// own[i]: the key of slot first + i * stride. passes: 1 to 3, the last one of which compares slots `stride` apart.
void exchange_eight(inout Key own[STRIDE_KEYS], uint first, uint stride, uint k, uint passes) {
    if (passes >= 3u) {
        for (uint i = 0u; i < 4u; ++i) {
            compare_exchange(own[i], own[i + 4u], first + i * stride, k);
        }
    }
    if (passes >= 2u) {
        for (uint i = 0u; i < 8u; i += 4u) {
            compare_exchange(own[i], own[i + 2u], first + i * stride, k);
            compare_exchange(own[i + 1u], own[i + 3u], first + (i + 1u) * stride, k);
        }
    }
    for (uint i = 0u; i < 8u; i += 2u) {
        compare_exchange(own[i], own[i + 1u], first + i * stride, k);
    }
}
