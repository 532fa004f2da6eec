// The mirror's collide against brute force, and what it promises besides.
#include "cpu/collide.h"

#include "cpu/cpu_backend.h"
#include "support/catch.h"
#include "support/stage_contract.h"

using namespace ballpit;

TEST_CASE("forces and integrators are those of brute force", "[mirror]") {
    cpu::CpuBackend<float> backend;
    test::collides_like_brute_force(backend, std::array{0u, 1u, 2u, 63u, 64u, 65u, 127u, 500u});
}

TEST_CASE("forces of the reference are those of brute force", "[mirror]") {
    cpu::CpuBackend<double> backend;
    test::collides_like_brute_force(backend, std::array{0u, 1u, 2u, 65u, 300u});
}

TEST_CASE("collide keeps its input and writes the other state", "[mirror]") {
    cpu::CpuBackend<float> backend;
    test::keeps_its_input(backend);
}

TEST_CASE("balls at the same place part, and momentum is kept", "[mirror]") {
    cpu::CpuBackend<float> backend;
    test::parts_coincident_balls(backend);
}

TEST_CASE("a ball that is no number is counted and infects nobody", "[mirror]") {
    cpu::CpuBackend<float> backend;
    test::contains_a_ball_that_is_no_number(backend);
}
