// The physics of the extremes on the GPU.
#include "support/catch.h"
#include "support/extreme_contract.h"
#include "support/gl_fixture.h"
#include "support/gpu_backend.h"

using namespace ballpit;
using test::GlFixture;

TEST_CASE_METHOD(GlFixture, "the GPU quarantines balls that are no number", "[extreme]") {
    test::quarantine_leaves_the_others_alone(test::gpu_backend);
}
TEST_CASE_METHOD(GlFixture, "the GPU's walls have a cap", "[extreme]") {
    test::walls_push_no_harder_than_their_cap(test::gpu_backend);
}
TEST_CASE_METHOD(GlFixture, "the GPU counts coincident balls", "[extreme]") {
    test::coincident_balls_are_counted(test::gpu_backend);
}
TEST_CASE_METHOD(GlFixture, "the GPU counts balls that are too fast", "[extreme]") {
    test::too_fast_balls_are_counted(test::gpu_backend);
}
TEST_CASE_METHOD(GlFixture, "no time changes no bit on the GPU", "[extreme]") {
    test::no_time_changes_no_bit(test::gpu_backend);
}
TEST_CASE_METHOD(GlFixture, "the GPU's semi-implicit dashpots hold", "[extreme]") {
    test::semi_implicit_dashpots_hold(test::gpu_backend);
}
TEST_CASE_METHOD(GlFixture, "the GPU relaxes overlaps", "[extreme]") { test::relaxing_parts_balls(test::gpu_backend); }
