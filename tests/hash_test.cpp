// The state hash: mixes well, sees every bit and every place, and adds up in any order.
#include "core/hash.h"

#include <cmath>
#include <utility>

#include "core/ball_state.h"
#include "support/catch.h"

using namespace ballpit;

TEST_CASE("words are mixed by the finaliser of MurmurHash3", "[core]") {
    CHECK(mix_word(0) == 0u);
    CHECK(mix_word(1) == 0x514E28B7u);
    CHECK(mix_word(2) == 0x30F4C306u);
}

TEST_CASE("the sum does not depend on the order, but on the places", "[core]") {
    HashSum forwards;
    HashSum backwards;
    HashSum exchanged;
    for (std::uint32_t i = 0; i < 100; ++i) {
        forwards.add(i * i, i);
        backwards.add((99 - i) * (99 - i), 99 - i);
        exchanged.add(i * i, i == 3 ? 4 : i == 4 ? 3 : i);
    }
    CHECK(forwards.value() == backwards.value());
    CHECK(forwards.value() != exchanged.value());
}

TEST_CASE("the hash of a state sees one bit of a position and of a velocity", "[core]") {
    BallState state{{vec4(1.0f), vec4(2.0f)}, {vec4(3.0f), vec4(4.0f)}, {}, 0.0};
    const std::uint64_t before = hash_state(state);
    CHECK(hash_state(state) == before);
    state.positions[1].z = std::nextafter(state.positions[1].z, 3.0f);
    const std::uint64_t moved = hash_state(state);
    CHECK(moved != before);
    state.velocities[0].x = -state.velocities[0].x;
    CHECK(hash_state(state) != moved);
}

TEST_CASE("the hash of a state sees two balls exchanged, one missing, and position put for velocity", "[core]") {
    BallState state{{vec4(1.0f), vec4(2.0f)}, {vec4(3.0f), vec4(4.0f)}, {}, 0.0};
    const std::uint64_t before = hash_state(state);
    BallState other = state;
    std::swap(other.positions[0], other.positions[1]);
    CHECK(hash_state(other) != before);
    std::swap(state.positions, state.velocities);
    CHECK(hash_state(state) != before);
    state.positions.pop_back();
    state.velocities.pop_back();
    CHECK(hash_state(state) != before);
    CHECK(hash_state(BallState{}) == 0);
}
