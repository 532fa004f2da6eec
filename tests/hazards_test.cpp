// Which use of a buffer must wait for which earlier one.
#include "core/hazards.h"

#include "support/catch.h"

using namespace ballpit;

namespace {

Dispatch dispatch_that(std::vector<Slot> reads, std::vector<Slot> writes) {
    Dispatch dispatch;
    dispatch.reads = std::move(reads);
    dispatch.writes = std::move(writes);
    return dispatch;
}

const Dispatch writes_keys = dispatch_that({Slot::positions}, {Slot::keys});
const Dispatch reads_keys = dispatch_that({Slot::keys}, {Slot::cell_ranges});
const Dispatch moves = dispatch_that({Slot::positions, Slot::keys}, {Slot::next_positions});

}  // namespace

TEST_CASE("what was written is waited for, what was only read is not", "[ledger]") {
    Hazards hazards;
    CHECK(hazards.before(writes_keys) == 0);
    hazards.ran(writes_keys);
    CHECK(hazards.before(dispatch_that({Slot::positions}, {})) == 0);
    CHECK(hazards.before(reads_keys) == only(Use::storage));
    CHECK(hazards.before(writes_keys) == only(Use::storage));  // twice the same slot: in order
    hazards.issued(only(Use::storage));
    CHECK(hazards.before(reads_keys) == 0);
}

TEST_CASE("a slot is not written while it may still be read", "[ledger]") {
    Hazards hazards;
    hazards.ran(reads_keys);
    CHECK(hazards.before(dispatch_that({Slot::keys}, {})) == 0);
    CHECK(hazards.before(writes_keys) == only(Use::storage));
    hazards.issued(only(Use::vertex));  // says nothing of storage
    CHECK(hazards.before(writes_keys) == only(Use::storage));
    hazards.issued(only(Use::storage));
    CHECK(hazards.before(writes_keys) == 0);
    hazards.shader_reads(Slot::keys);  // a shader beside the schedule, such as the hash
    CHECK(hazards.before(writes_keys) == only(Use::storage));
}

TEST_CASE("each use waits by itself, and a barrier covers every buffer", "[ledger]") {
    Hazards hazards;
    hazards.ran(reads_keys);
    hazards.ran(writes_keys);
    for (const Use use : {Use::storage, Use::vertex, Use::texture, Use::copy}) {
        CHECK(hazards.before_use(Slot::keys, use) == only(use));
        CHECK(hazards.before_use(Slot::cell_ranges, use) == only(use));
        CHECK(hazards.before_use(Slot::positions, use) == 0);
    }
    hazards.issued(only(Use::copy) | only(Use::texture));
    for (const Slot slot : {Slot::keys, Slot::cell_ranges}) {
        CHECK(hazards.before_use(slot, Use::copy) == 0);
        CHECK(hazards.before_use(slot, Use::texture) == 0);
        CHECK(hazards.before_use(slot, Use::vertex) == only(Use::vertex));
    }
}

TEST_CASE("a buffer keeps its hazards when roles are exchanged", "[ledger]") {
    Hazards hazards;
    hazards.ran(moves);
    CHECK(hazards.before_use(Slot::positions, Use::vertex) == 0);
    hazards.swap_states();
    CHECK(hazards.physical(Slot::positions) == static_cast<std::size_t>(Slot::next_positions));
    CHECK(hazards.physical(Slot::keys) == static_cast<std::size_t>(Slot::keys));
    CHECK(hazards.before_use(Slot::positions, Use::vertex) == only(Use::vertex));
    CHECK(hazards.before_use(Slot::next_positions, Use::vertex) == 0);
    hazards.swap_states();
    CHECK(hazards.before_use(Slot::next_positions, Use::vertex) == only(Use::vertex));
    hazards.swap_copies();
    CHECK(hazards.physical(Slot::next_positions) == static_cast<std::size_t>(Slot::sorted_positions));
    CHECK(hazards.before_use(Slot::sorted_positions, Use::vertex) == only(Use::vertex));
    CHECK(hazards.before_use(Slot::next_positions, Use::vertex) == 0);
    hazards.swap_states();  // the state can be in any of three buffers
    CHECK(hazards.physical(Slot::positions) == static_cast<std::size_t>(Slot::sorted_positions));
    CHECK(hazards.physical(Slot::next_positions) == static_cast<std::size_t>(Slot::positions));
}
