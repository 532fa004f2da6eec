// A long dispatch in slices, on the device: the same bits, and as many dispatches as the limit asks for.
#include <cstring>

#include "core/dispatch_slices.h"
#include "core/hash.h"
#include "core/simulation.h"
#include "support/catch.h"
#include "support/gl_fixture.h"
#include "support/gpu_backend.h"
#include "support/law_scenes.h"

using namespace ballpit;
using test::GlFixture;

namespace {

constexpr std::uint32_t balls = 1000;  // sixteen work groups, the last one not full
constexpr int substeps = 5;

struct Outcome {
    std::vector<std::uint64_t> hashes;
    Status status{};
    std::vector<MeterRecord> records;
    std::uint64_t dispatches = 0;  // of all substeps
    std::uint64_t listed = 0;      // what the schedules have
};

// Unequal balls, crowded, that touch and are counted and metered.
Scene crowd(NeighbourSearch search, std::uint32_t grid_reuse) {
    Scene scene = test::scene_with("gravity,contact,restitution,walls,diagnostics", balls);
    scene.fill->radius = {0.05, 0.2};
    scene.settings.neighbours = search;
    scene.settings.grid_reuse = grid_reuse;
    scene.settings.substeps = substeps;
    return scene;
}

Outcome run(const Scene& scene, double limit) {
    auto owned = test::gpu_backend();
    gpu::GpuBackend& backend = *owned;
    backend.set_slice_limit(limit);
    Simulation simulation(scene, scene.settings, 1, std::move(owned));
    simulation.set_metering(true);
    Outcome outcome;
    for (int i = 0; i < substeps; ++i) {
        outcome.listed += simulation.schedule().dispatches.size();
        simulation.substep();
        outcome.hashes.push_back(hash_state(simulation.raw_state()));
        for (const MeterRecord& record : simulation.take_records()) {
            outcome.records.push_back(record);
        }
    }
    outcome.dispatches = backend.dispatches_issued();
    outcome.status = read_slot<Status>(backend, Slot::status).front();
    while (outcome.records.size() < substeps) {
        for (const MeterRecord& record : simulation.take_records()) {
            outcome.records.push_back(record);
        }
    }
    return outcome;
}

template <class T>
bool same_bytes(const T& a, const T& b) {
    static_assert(std::has_unique_object_representations_v<T> || std::is_same_v<T, MeterReading>);
    return std::memcmp(&a, &b, sizeof(T)) == 0;
}

// `sliced`: how many dispatches of those substeps look at pairs. Whatever the limit, some slice has a ball.
void same_in_slices(const Scene& scene, std::uint64_t sliced) {
    const Outcome whole = run(scene, 1e12);
    CHECK(whole.dispatches == whole.listed);
    for (const double limit : {9e5, 1.0}) {
        const Outcome cut = run(scene, limit);
        CAPTURE(limit);
        CHECK(cut.hashes == whole.hashes);
        CHECK(same_bytes(cut.status, whole.status));
        for (std::size_t i = 0; i < substeps; ++i) {
            CHECK(same_bytes(cut.records[i].reading, whole.records[i].reading));
        }
        CHECK(cut.dispatches > cut.listed);
        if (limit == 1.0) {
            CHECK(cut.dispatches == cut.listed + 15 * sliced);
        }
    }
}

}  // namespace

TEST_CASE_METHOD(GlFixture, "brute force in slices gives the same bits", "[gpu-backend]") {
    const Scene scene = crowd(NeighbourSearch::brute_force, 1);
    same_in_slices(scene, substeps);
    CHECK(run(scene, 0.25 * balls * balls).dispatches == 4 * substeps);
}

TEST_CASE_METHOD(GlFixture, "a grid's collide and count of what was missed in slices give the same bits",
                 "[gpu-backend]") {
    Scene scene = crowd(NeighbourSearch::grid, 2);
    scene.settings.cell_factor = 100.0;   // all in one cell
    same_in_slices(scene, substeps + 3);  // three of five build the grid
}

TEST_CASE_METHOD(GlFixture, "the counting sort's cells are put in order in slices, too", "[gpu-backend]") {
    Scene scene = crowd(NeighbourSearch::grid, 1);
    scene.settings.sort = SortMethod::counting;
    scene.settings.cell_factor = 3.0;     // in one cell the keys would be in order beforehand
    same_in_slices(scene, 2 * substeps);  // order_keys and collide
}

TEST_CASE_METHOD(GlFixture, "few balls, or balls that do not look at others, are not cut", "[gpu-backend]") {
    const Scene crowded = crowd(NeighbourSearch::brute_force, 1);
    CHECK(run(crowded, 1.0 * balls * balls).dispatches == substeps);
    auto owned = test::gpu_backend();
    gpu::GpuBackend& backend = *owned;
    backend.set_slice_limit(1.0);
    const Scene alone = test::scene_with("gravity,diagnostics", balls);
    Simulation simulation(alone, alone.settings, 1, std::move(owned));
    simulation.substep();
    CHECK(backend.dispatches_issued() == 1);
}
