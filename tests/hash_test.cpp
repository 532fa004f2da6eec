// The state hash, against published values of FNV-1a.
#include "core/hash.h"

#include <string_view>

#include "core/ball_state.h"
#include "support/catch.h"

using namespace ballpit;

namespace {

std::uint64_t hash_text(std::string_view text) { return hash_bytes(std::as_bytes(std::span(text))); }

}  // namespace

TEST_CASE("the hash is 64-bit FNV-1a", "[core]") {
    CHECK(hash_text("") == 0xCBF29CE484222325ull);
    CHECK(hash_text("a") == 0xAF63DC4C8601EC8Cull);
    CHECK(hash_text("foobar") == 0x85944171F73967E8ull);
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
