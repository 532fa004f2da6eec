// The GPU as a backend: the promises of the interface, what drawing needs, and limits.
#include "gpu/gpu_backend.h"

#include "core/error.h"
#include "support/backend_contract.h"
#include "support/catch.h"
#include "support/gl_fixture.h"
#include "support/gpu_backend.h"
#include "support/substep_setup.h"

using namespace ballpit;
using test::GlFixture;

TEST_CASE_METHOD(GlFixture, "the GPU reads what was loaded and written", "[gpu-backend]") {
    const auto backend = test::gpu_backend();
    test::reads_what_was_loaded(*backend);
    test::reads_what_was_written(*backend);
}

TEST_CASE_METHOD(GlFixture, "the GPU's copies arrive as of the request", "[gpu-backend]") {
    test::copies_arrive_as_of_the_request(*test::gpu_backend());
}

TEST_CASE_METHOD(GlFixture, "the GPU's buffers grow and shrink", "[gpu-backend]") {
    test::buffers_grow_and_shrink(*test::gpu_backend());
}

TEST_CASE_METHOD(GlFixture, "the GPU remembers states", "[gpu-backend]") {
    test::remembers_states(*test::gpu_backend());
}

TEST_CASE_METHOD(GlFixture, "the GPU reschedules in the middle", "[gpu-backend]") {
    test::reschedules_in_the_middle(*test::gpu_backend());
}

TEST_CASE_METHOD(GlFixture, "the GPU times every stage", "[gpu-backend]") {
    test::times_every_stage(*test::gpu_backend());
}

TEST_CASE_METHOD(GlFixture, "the GPU's status adds up", "[gpu-backend]") { test::status_adds_up(*test::gpu_backend()); }

TEST_CASE_METHOD(GlFixture, "the GPU saves and restores", "[gpu-backend]") {
    test::saves_and_restores(*test::gpu_backend());
}

TEST_CASE_METHOD(GlFixture, "the GPU hashes its state", "[gpu-backend]") {
    test::hashes_the_state(*test::gpu_backend());
}

TEST_CASE_METHOD(GlFixture, "the GPU works in place", "[gpu-backend]") { test::works_in_place(*test::gpu_backend()); }

TEST_CASE_METHOD(GlFixture, "what the GPU has no room for leaves what it holds alone", "[gpu-backend]") {
    const auto backend = test::gpu_backend();
    const BallState state = test::placed_balls(test::Placement::uniform, 100);
    const auto setup = test::setup_for(state, test::contact_features(), SortMethod::bitonic_fused);
    backend->load(state, setup.schedule, true);
    Schedule vast = setup.schedule;
    vast.ball_count = 1u << 30;  // 16 GiB a state: no device allows that much a buffer
    try {
        backend->load(state, vast, true);
        FAIL("16 GiB a buffer were not refused");
    } catch (const NoRoom& error) {
        INFO(error.what());
        CHECK(std::string(error.what()).find("balls fit") != std::string::npos);
    }
    CHECK(read_slot<vec4>(*backend, Slot::positions) == state.positions);
    backend->run(setup.schedule, setup.params, 0, setup.schedule.dispatches.size());
    backend->swap_states();
    CHECK(read_slot<vec4>(*backend, Slot::positions).size() == state.count());
}

TEST_CASE_METHOD(GlFixture, "drawing gets the buffer that holds the state", "[gpu-backend]") {
    const auto backend = test::gpu_backend();
    const BallState state = test::placed_balls(test::Placement::uniform, 100);
    const auto setup = test::setup_for(state, test::contact_features(), SortMethod::bitonic_fused);
    backend->load(state, setup.schedule, true);
    for (int i = 0; i < 3; ++i) {
        backend->run(setup.schedule, setup.params, 0, setup.schedule.dispatches.size());
        backend->swap_states();
        const Bytes drawn = backend->buffer_for_drawing(Slot::positions).read();
        const Bytes read = backend->read(Slot::positions);
        REQUIRE(drawn.size() >= read.size());
        CHECK(std::equal(read.begin(), read.end(), drawn.begin()));
    }
    CHECK(backend->allocated_bytes() >= 100 * 4 * sizeof(vec4));
}
