// E24 of docs/extremes.md, ten times as long: balls that bounce between two walls for a million substeps.
#include <algorithm>
#include <memory>

#include "core/simulation.h"
#include "cpu/cpu_backend.h"
#include "measure/energy.h"
#include "support/catch.h"

using namespace ballpit;

TEST_CASE("a million substeps of bouncing balls gain and lose no energy in the mean", "[bounces]") {
    Scene scene;
    scene.name = "bounces";
    scene.half_extent = dvec3(1.0);
    scene.settings.laws = parse_laws("walls");
    scene.settings.stiffness = 1e4;
    scene.settings.substeps = 1000;
    scene.settings.dt = 1000.0 / 960.0;
    for (int i = 0; i < 32; ++i) {  // speeds that are no whole number of each other
        scene.balls.push_back({dvec3(0.0), dvec3(1.0 + 0.618 * i, 0.0, 0.0), 0.1, 1.0, {}, {}, false});
    }
    scene.settings.balls = 32;
    Simulation simulation(scene, scene.settings, 1, std::make_unique<cpu::CpuBackend<float>>());
    const auto energy = [&] {
        const measure::Totals totals = measure::totals_of(simulation.synchronised_state(), simulation.settings(),
                                                          simulation.features(), simulation.box());
        return totals.kinetic + totals.elastic;
    };
    const double start = energy();
    double least = 1.0;
    double most = 1.0;
    double sum = 0.0;
    for (int step = 0; step < 1000; ++step) {
        simulation.step();
        const double share = energy() / start;
        least = std::min(least, share);
        most = std::max(most, share);
        sum += step < 500 ? -share : share;
    }
    CAPTURE(least, most, sum / 500);
    CHECK(simulation.step_count() == 1000);
    CHECK(most < 1.02);
    CHECK(least > 0.98);
    CHECK(std::abs(sum / 500) < 0.005);  // the second half against the first: no drift
}
