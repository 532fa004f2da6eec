// What a device has no room for is refused before anything changes.
#include "core/storage_limits.h"

#include "core/error.h"
#include "core/ledger.h"
#include "core/simulation.h"
#include "cpu/cpu_backend.h"
#include "support/catch.h"
#include "support/scenes.h"

using namespace ballpit;

namespace {

constexpr std::size_t mebibyte = 1u << 20;

Schedule schedule_of(std::uint32_t balls, bool compensated = false) {
    Features features;
    features.add(Feature::contact);
    features.add(Feature::compensated, compensated);
    return make_schedule(balls, make_grid(dvec3(1.0), 0.1, 1.0, balls), features, SortMethod::bitonic_fused);
}

std::string refusal(const Schedule& schedule, const StorageLimits& limits) {
    try {
        expect_storage(schedule, limits);
    } catch (const NoRoom& error) {
        return error.what();
    }
    return "";
}

// A device that has room for few balls, told or found out.
class SmallDevice final : public cpu::CpuBackend<float> {
public:
    SmallDevice(std::size_t block_bytes, std::uint32_t most_balls) : most_balls_(most_balls) {
        limits_.block_bytes = block_bytes;
    }
    StorageLimits storage_limits() const override { return limits_; }
    void load(const BallState& state, const Schedule& schedule, bool limit_force) override {
        expect_storage(schedule, limits_);
        if (schedule.ball_count > most_balls_) {
            throw NoRoom("the device has no room");
        }
        CpuBackend::load(state, schedule, limit_force);
    }

private:
    StorageLimits limits_;
    std::uint32_t most_balls_;
};

constexpr std::size_t any_size = std::numeric_limits<std::size_t>::max();
constexpr std::uint32_t any_count = std::numeric_limits<std::uint32_t>::max();

Simulation simulation_on(std::unique_ptr<Backend> backend) {
    Scene scene = test::shipped_scene("rain");
    scene.settings.balls = 200;
    Simulation simulation(scene, scene.settings, 5, std::move(backend));
    simulation.step();
    return simulation;
}

}  // namespace

TEST_CASE("what fits is not refused, and the largest count that fits is the largest", "[storage]") {
    StorageLimits limits;
    CHECK(refusal(schedule_of(100000), limits).empty());
    limits.block_bytes = mebibyte;  // 65536 states, 131072 keys
    CHECK(refusal(schedule_of(65536), limits).empty());
    CHECK(most_balls_that_fit(schedule_of(65536), limits) == 65536);
    CHECK(most_balls_that_fit(schedule_of(1000000), limits) == 65536);
    CHECK(most_balls_that_fit(schedule_of(1000000, true), limits) == mebibyte / sizeof(Compensation));
    const std::string words = refusal(schedule_of(65537), limits);
    CHECK(words.find("65537 balls would need 2 MiB for buffer 'positions'") != std::string::npos);
    CHECK(words.find("at most 65536 balls fit") != std::string::npos);
}

TEST_CASE("all buffers together must fit into the memory that is free", "[storage]") {
    StorageLimits limits;
    limits.free_bytes = 8 * mebibyte;
    const std::uint32_t most = most_balls_that_fit(schedule_of(1000000), limits);
    CHECK(most > 50000);
    CHECK(refusal(schedule_of(most), limits).empty());
    const std::string words = refusal(schedule_of(most + 1), limits);
    CHECK(words.find("of which 8 MiB are free: at most " + std::to_string(most) + " balls fit") != std::string::npos);
}

TEST_CASE("a device without room leaves the running scene as it was", "[storage]") {
    const bool found_out = GENERATE(false, true);
    INFO((found_out ? "the device finds it out" : "the device tells it"));
    auto device =
        found_out ? std::make_unique<SmallDevice>(any_size, 1000) : std::make_unique<SmallDevice>(300000, any_count);
    Simulation simulation = simulation_on(std::move(device));
    Simulation untouched = simulation_on(std::make_unique<cpu::CpuBackend<float>>());
    Settings more = simulation.settings();
    more.balls = 100000;
    CHECK_THROWS_AS(simulation.change(more), NoRoom);
    const Scene pile = test::shipped_scene("pile");
    Settings of_many = pile.settings;
    of_many.balls = 100000;
    CHECK_THROWS_AS(simulation.load(pile, of_many, 1), NoRoom);
    CHECK_THROWS_AS(simulation.add({std::vector<BallSpec>(20000, BallSpec{{}, {}, 0.1, 1.0, std::nullopt})}), NoRoom);
    CHECK(simulation.scene().name == untouched.scene().name);
    CHECK(simulation.settings() == untouched.settings());
    CHECK(simulation.added() == 0);
    CHECK(simulation.step_count() == 1);
    simulation.step();
    untouched.step();
    CHECK(hash_state(simulation.raw_state()) == hash_state(untouched.raw_state()));
    more.balls = 600;
    CHECK_NOTHROW(simulation.change(more));
}
