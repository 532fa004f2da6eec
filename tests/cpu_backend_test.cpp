// The mirror and the reference as backends.
#include "cpu/cpu_backend.h"

#include "support/backend_contract.h"
#include "support/catch.h"

using namespace ballpit;

TEMPLATE_TEST_CASE("the mirror keeps the backend's promises", "[mirror]", float, double) {
    cpu::CpuBackend<TestType> backend;
    test::reads_what_was_loaded(backend);
    test::reads_what_was_written(backend);
    test::copies_arrive_as_of_the_request(backend);
    test::buffers_grow_and_shrink(backend);
    test::reschedules_in_the_middle(backend);
    test::times_every_stage(backend);
    test::status_adds_up(backend);
    test::saves_and_restores(backend);
    test::remembers_states(backend);
    test::works_in_place(backend);
}

TEST_CASE("the mirror hashes its state", "[mirror]") {
    cpu::CpuBackend<float> backend;
    test::hashes_the_state(backend);
}
