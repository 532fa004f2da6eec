// Which sort a running scene takes where the settings leave it open.
#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>

#include "core/error.h"
#include "core/simulation.h"
#include "cpu/cpu_backend.h"
#include "support/catch.h"
#include "support/scenes.h"

using namespace ballpit;

namespace {

// A device on which one way to sort takes much longer than the other.
class SlowSort final : public cpu::CpuBackend<float> {
public:
    explicit SlowSort(Stage slow) : slow_(slow) {}

    void run(const Schedule& schedule, const SubstepParams<double>& params, std::size_t first,
             std::size_t last) override {
        if (std::ranges::find(schedule.dispatches, slow_, &Dispatch::stage) != schedule.dispatches.end()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(3));
        }
        CpuBackend<float>::run(schedule, params, first, last);
    }

private:
    Stage slow_;
};

// A device without memory for what the counting sort needs beside the keys.
class Roomless final : public cpu::CpuBackend<float> {
public:
    void reschedule(const Schedule& schedule) override {
        if (schedule.counts_cells) {
            throw NoRoom("no room");
        }
        CpuBackend<float>::reschedule(schedule);
    }
};

}  // namespace

TEST_CASE("an open sort is chosen anew where another backend takes over", "[simulation]") {
    const Scene scene = test::shipped_scene("rain");
    Settings settings = scene.settings;
    settings.balls = 100;
    settings.sort = SortMethod::automatic;
    Simulation simulation(scene, settings, 1, std::make_unique<SlowSort>(Stage::counting_sort));
    CHECK_FALSE(simulation.schedule().counts_cells);
    simulation.step();
    const std::uint64_t before = hash_state(simulation.raw_state());
    simulation.use(std::make_unique<SlowSort>(Stage::bitonic_sort));
    CHECK(simulation.schedule().counts_cells);
    CHECK(hash_state(simulation.raw_state()) == before);
    simulation.use(std::make_unique<SlowSort>(Stage::counting_sort));
    CHECK_FALSE(simulation.schedule().counts_cells);
    // One that was named stays.
    settings.sort = SortMethod::bitonic;
    simulation.change(settings);
    simulation.use(std::make_unique<SlowSort>(Stage::bitonic_sort));
    CHECK_FALSE(simulation.schedule().counts_cells);
}

TEST_CASE("an open sort is one that the device has room for", "[simulation]") {
    const Scene scene = test::shipped_scene("rain");
    Settings settings = scene.settings;
    settings.balls = 100;
    settings.sort = SortMethod::automatic;
    Simulation simulation(scene, settings, 1, std::make_unique<Roomless>());
    CHECK_FALSE(simulation.schedule().counts_cells);
    simulation.step();
    CHECK(simulation.step_count() == 1);
}
