// Counting sort, strides and sorted copies on the GPU.
#include "support/catch.h"
#include "support/counting_contract.h"
#include "support/gl_fixture.h"
#include "support/gpu_backend.h"
#include "support/stage_contract.h"

using namespace ballpit;
using test::GlFixture;

TEST_CASE_METHOD(GlFixture, "GPU: the counting sort sorts every pattern at many sizes", "[gpu]") {
    // In patterns that put all balls into one cell each looks at every other one: larger counts take long.
    test::counts_and_sorts_every_pattern(*test::gpu_backend(), test::interesting_counts(5000));
}

TEST_CASE_METHOD(GlFixture, "GPU: every sort, with copies and without, gives the same run in every scene", "[gpu]") {
    test::same_run_however_computed(test::gpu_backend, 100, 3);
}

TEST_CASE_METHOD(GlFixture, "GPU: changed while it runs, sort and copies change no bit", "[gpu]") {
    test::changes_of_computing_change_nothing(test::gpu_backend);
}

TEST_CASE_METHOD(GlFixture, "GPU: auto is one of the sorts, and counts nothing twice", "[gpu]") {
    test::automatic_sort_is_one_of_them(test::gpu_backend);
}
