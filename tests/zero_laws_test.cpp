// A law with a coefficient of zero is no law, to the last bit: the mirror.
#include "support/zero_laws.h"

#include "cpu/cpu_backend.h"
#include "support/catch.h"

using namespace ballpit;

TEST_CASE("a law that is compiled in and does nothing changes no bit of a run", "[zero-laws]") {
    for (std::size_t i = 0; i < integrator_names.size(); ++i) {
        for (const NeighbourSearch neighbours : {NeighbourSearch::grid, NeighbourSearch::brute_force}) {
            test::zero_laws_change_no_bit([] { return std::make_unique<cpu::CpuBackend<float>>(); },
                                          static_cast<Integrator>(i), neighbours);
        }
    }
}
