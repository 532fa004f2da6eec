// The state hash: published values of its mixer, and what it must tell apart.
#include "core/hash.h"

#include <cmath>

#include "core/ball_state.h"
#include "support/catch.h"

using namespace ballpit;

TEST_CASE("words are mixed by MurmurHash3's finaliser", "[core]") {
    CHECK(mix_word(0u) == 0u);
    CHECK(mix_word(1u) == 0x514E28B7u);
    CHECK(mix_word(0xFFFFFFFFu) == 0x81F16F39u);
}

TEST_CASE("the hash does not depend on the order of adding, but on the place", "[core]") {
    HashSum forth;
    HashSum back;
    HashSum exchanged;
    for (std::uint32_t i = 0; i < 100; ++i) {
        forth.add(i * i, i);
        back.add((99 - i) * (99 - i), 99 - i);
        exchanged.add(i * i, i < 2 ? 1 - i : i);
    }
    CHECK(forth.value() == back.value());
    CHECK(forth.value() != exchanged.value());
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
