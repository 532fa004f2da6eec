// Each stage on the GPU against brute force and invariants: the same lines that the mirror is held to.
#include "support/catch.h"
#include "support/gl_fixture.h"
#include "support/gpu_backend.h"
#include "support/stage_contract.h"

using namespace ballpit;
using test::GlFixture;

TEST_CASE_METHOD(GlFixture, "the GPU assigns cells", "[gpu-stages]") {
    test::assigns_cells(*test::gpu_backend(), test::interesting_counts(5000));
}

TEST_CASE_METHOD(GlFixture, "the GPU assigns points on faces, outside and of no number", "[gpu-stages]") {
    test::assigns_strange_points(*test::gpu_backend());
}

TEST_CASE_METHOD(GlFixture, "the GPU sorts every pattern pass by pass", "[gpu-stages]") {
    test::sorts_every_pattern(*test::gpu_backend(), SortMethod::bitonic, test::interesting_counts(65537));
}

TEST_CASE_METHOD(GlFixture, "the GPU sorts every pattern in fused passes", "[gpu-stages]") {
    test::sorts_every_pattern(*test::gpu_backend(), SortMethod::bitonic_fused, test::interesting_counts(65537));
}

TEST_CASE_METHOD(GlFixture, "the GPU builds the grid", "[gpu-stages]") {
    test::builds_the_grid(*test::gpu_backend(), test::interesting_counts(65537));
}

TEST_CASE_METHOD(GlFixture, "the GPU counts keys of no cell", "[gpu-stages]") {
    test::refuses_keys_of_no_cell(*test::gpu_backend());
}

TEST_CASE_METHOD(GlFixture, "the GPU's grid finds the pairs of brute force", "[gpu-stages]") {
    test::finds_every_pair(*test::gpu_backend(), std::array{0u, 1u, 2u, 63u, 64u, 65u, 127u, 1000u, 4097u});
}

TEST_CASE_METHOD(GlFixture, "the GPU's forces and integrators are those of brute force", "[gpu-stages]") {
    test::collides_like_brute_force(*test::gpu_backend(), std::array{0u, 1u, 2u, 64u, 65u, 300u});
}

TEST_CASE_METHOD(GlFixture, "the GPU's collide keeps its input", "[gpu-stages]") {
    test::keeps_its_input(*test::gpu_backend());
}

TEST_CASE_METHOD(GlFixture, "balls at the same place part on the GPU", "[gpu-stages]") {
    test::parts_coincident_balls(*test::gpu_backend());
}

TEST_CASE_METHOD(GlFixture, "a ball that is no number is counted on the GPU and infects nobody", "[gpu-stages]") {
    test::contains_a_ball_that_is_no_number(*test::gpu_backend());
}
