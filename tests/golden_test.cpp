// One hash per shipped scene on the mirror: the same bits on every compiler and at every optimisation level. If a
// change of the physics or of a scene is meant, the failing test prints the new number.
#include <array>
#include <cstdio>
#include <memory>
#include <string>

#include "core/simulation.h"
#include "cpu/cpu_backend.h"
#include "support/catch.h"
#include "support/scenes.h"

using namespace ballpit;

namespace {

struct Golden {
    std::string_view scene;
    int steps;
    std::uint64_t hash;
};

constexpr std::array goldens = {
    Golden{"bench_pile", 120, 0x17CC762FE624E70B},
    Golden{"cannonball", 8, 0x710FF2FD78D50F3A},
    Golden{"column_of_ten", 60, 0xBC0966DA0060A252},
    Golden{"cooling_gas", 15, 0x09D48AE90F584FA3},
    Golden{"elastic_gas", 40, 0x89F10239016937C1},
    Golden{"free_fall", 3, 0x2531E98812948A8A},
    Golden{"historical", 15, 0x560B2E8465303CE0},
    Golden{"hot_corner", 15, 0xDD302252D017357A},
    Golden{"kicked_chain", 60, 0x68EF14D55FCB59F5},
    Golden{"mixed_sizes", 20, 0xEB3ABE13CED03494},
    Golden{"newtons_cradle", 120, 0x19760AB97886E5C6},
    Golden{"oblique_pair", 60, 0x353AA43C41E05224},
    Golden{"one_cell", 30, 0x4DDE23FAF41C6CF3},
    Golden{"pile", 60, 0x5C83C2DD72F401F7},
    Golden{"projectile_with_drag", 150, 0x15147E94D0A1CC85},
    Golden{"rain", 70, 0xA2736C9F808249E7},
    Golden{"two_balls", 60, 0x5A95D07841BF754C},
    Golden{"unequal_pair", 60, 0xF89943C1EF3C730A},
};

std::string hexadecimal(std::uint64_t hash) {
    std::array<char, 24> text{};
    std::snprintf(text.data(), text.size(), "0x%016llX", static_cast<unsigned long long>(hash));
    return text.data();
}

}  // namespace

TEST_CASE("every scene runs to the same bits", "[golden]") {
    CHECK(goldens.size() == test::shipped_scene_names.size());
    for (const Golden& golden : goldens) {
        const Scene scene = test::shipped_scene(golden.scene);
        Simulation simulation(scene, scene.settings, test::seed_of(scene), std::make_unique<cpu::CpuBackend<float>>());
        for (int i = 0; i < golden.steps; ++i) {
            simulation.step();
        }
        CAPTURE(golden.scene, golden.steps);
        CHECK(hexadecimal(hash_state(simulation.raw_state())) == hexadecimal(golden.hash));
        const auto status = read_slot<Status>(simulation.backend(), Slot::status)[0];
        CHECK(status.not_finite == 0);
        CHECK(status.over_capacity == 0);
    }
}
