// The check of a backend against the mirror, on a backend with a planted fault: it must name stage and place, and
// blame no stage behind it.
#include "measure/check.h"

#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "cpu/cpu_backend.h"
#include "support/catch.h"
#include "support/scenes.h"
#include "support/substep_setup.h"

using namespace ballpit;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// The mirror with one fault: after a dispatch of `stage`, `fault` changes what it left.
class FaultyBackend final : public Backend {
public:
    using Fault = void (*)(Backend&);

    FaultyBackend(Stage stage, Fault fault) : stage_(stage), fault_(fault) {}

    std::string_view name() const override { return inner_.name(); }
    std::string device() const override { return inner_.device(); }
    std::string driver() const override { return inner_.driver(); }
    void load(const BallState& state, const Schedule& schedule, bool limit_force) override {
        inner_.load(state, schedule, limit_force);
    }
    void reschedule(const Schedule& schedule) override { inner_.reschedule(schedule); }
    void run(const Schedule& schedule, const SubstepParams<double>& params, std::size_t first,
             std::size_t last) override {
        for (std::size_t i = first; i < last; ++i) {
            inner_.run(schedule, params, i, i + 1);
            const bool stage_ends = i + 1 == schedule.dispatches.size() || schedule.dispatches[i + 1].stage != stage_;
            if (schedule.dispatches[i].stage == stage_ && stage_ends) {
                fault_(inner_);
            }
        }
    }
    void swap_states() override { inner_.swap_states(); }
    std::unique_ptr<SavedState> save() override { return inner_.save(); }
    void restore(const SavedState& state, const Schedule& schedule) override { inner_.restore(state, schedule); }
    void request_hash(std::uint64_t tag) override { inner_.request_hash(tag); }
    std::vector<TaggedHash> take_hashes() override { return inner_.take_hashes(); }
    void request_reading(std::uint64_t tag, const Schedule& schedule, const SubstepParams<double>& params,
                         const Synchronisation& synchronisation) override {
        inner_.request_reading(tag, schedule, params, synchronisation);
    }
    std::vector<TaggedReading> take_readings() override { return inner_.take_readings(); }
    std::vector<double> take_reading_times() override { return inner_.take_reading_times(); }
    Bytes read(Slot slot) override { return inner_.read(slot); }
    void write(Slot slot, std::span<const std::byte> bytes) override { inner_.write(slot, bytes); }
    void request(Slot slot) override { inner_.request(slot); }
    std::optional<Bytes> poll(Slot slot) override { return inner_.poll(slot); }
    void start_history(std::uint32_t entries) override { inner_.start_history(entries); }
    void record_history() override { inner_.record_history(); }
    void request_history() override { inner_.request_history(); }
    std::optional<Bytes> poll_history() override { return inner_.poll_history(); }
    void set_timing(bool on) override { inner_.set_timing(on); }
    std::vector<StageTimes> take_times() override { return inner_.take_times(); }
    void finish() override { inner_.finish(); }

private:
    cpu::CpuBackend<float> inner_;
    Stage stage_;
    Fault fault_;
};

measure::CheckReport check_with_fault(Stage stage, FaultyBackend::Fault fault) {
    const Scene scene = test::shipped_scene("rain");
    Settings settings = scene.settings;
    settings.balls = 200;
    settings.substeps = 2;
    Simulation simulation(scene, settings, 42, std::make_unique<FaultyBackend>(stage, fault));
    cpu::CpuBackend<float> mirror;
    return measure::check(simulation, mirror, 1);
}

const measure::CheckRow& row_of(const measure::CheckReport& report, Stage stage, Slot slot) {
    for (const measure::CheckRow& row : report.rows) {
        if (row.stage == stage && row.slot == slot) {
            return row;
        }
    }
    FAIL("no such row");
    return report.rows.front();
}

template <class T, class Change>
void change_slot(Backend& backend, Slot slot, Change change) {
    auto elements = read_slot<T>(backend, slot);
    change(elements);
    test::write_slot(backend, slot, elements);
}

}  // namespace

TEST_CASE("a backend without fault passes", "[sabotage]") {
    const auto report = check_with_fault(Stage::collide, [](Backend&) {});
    CHECK(report.passed());
    CHECK(report.steps == 1);
    CHECK(report.substeps == 2);
    CHECK(report.violations.empty());
}

TEST_CASE("check names the stage in which a cell id is wrong", "[sabotage]") {
    const auto report = check_with_fault(Stage::assign_cells, [](Backend& backend) {
        change_slot<Key>(backend, Slot::keys, [](std::vector<Key>& keys) { keys[12].cell_id += 1; });
    });
    CHECK_FALSE(report.passed());
    const auto& row = row_of(report, Stage::assign_cells, Slot::keys);
    CHECK(row.beyond_bound == 2);  // once a substep
    CHECK(contains(row.first, "substep 0, assign_cells, slot 12: "));
    // The stages behind it worked on what they were given: they are not to blame.
    CHECK(row_of(report, Stage::bitonic_sort, Slot::keys).beyond_bound == 0);
    CHECK(row_of(report, Stage::collide, Slot::next_positions).beyond_bound == 0);
}

TEST_CASE("check names the stage in which a key is lost", "[sabotage]") {
    const auto report = check_with_fault(Stage::bitonic_sort, [](Backend& backend) {
        change_slot<Key>(backend, Slot::keys, [](std::vector<Key>& keys) { keys[20] = keys[21]; });
    });
    CHECK(row_of(report, Stage::bitonic_sort, Slot::keys).beyond_bound == 2);
    REQUIRE_FALSE(report.violations.empty());
    CHECK(contains(report.violations.front(), "substep 0, after bitonic_sort: slot 21 holds ball"));
}

TEST_CASE("check names the stage in which a range is off by one", "[sabotage]") {
    const auto report = check_with_fault(Stage::build_grid, [](Backend& backend) {
        change_slot<CellRange>(backend, Slot::cell_ranges, [](std::vector<CellRange>& ranges) {
            for (CellRange& range : ranges) {
                if (range.end != 0) {
                    --range.end;
                    return;
                }
            }
        });
    });
    CHECK(row_of(report, Stage::build_grid, Slot::cell_ranges).beyond_bound == 2);
    REQUIRE_FALSE(report.violations.empty());
    CHECK(contains(report.violations.front(), "after build_grid: "));
}

TEST_CASE("check names the ball whose velocity is wrong, and the one that is no number", "[sabotage]") {
    const auto shifted = check_with_fault(Stage::collide, [](Backend& backend) {
        change_slot<vec4>(backend, Slot::next_velocities, [](std::vector<vec4>& all) { all[33].x += 1e-3f; });
    });
    CHECK_FALSE(shifted.passed());
    CHECK(contains(row_of(shifted, Stage::collide, Slot::next_velocities).first, "substep 0, collide, ball 33: "));
    const auto broken = check_with_fault(Stage::collide, [](Backend& backend) {
        change_slot<vec4>(backend, Slot::next_positions, [](std::vector<vec4>& all) { all[34].z = not_a_number; });
    });
    CHECK_FALSE(broken.passed());
    CHECK(contains(broken.violations.front(), "after collide: ball 34 "));
}

TEST_CASE("a ball in free flight has no room for rounding", "[sabotage]") {
    // Without contacts there is no division: one ulp is one too many.
    const auto report = check_with_fault(Stage::collide, [](Backend& backend) {
        change_slot<vec4>(backend, Slot::next_velocities,
                          [](std::vector<vec4>& all) { all[2].z = std::nextafter(all[2].z, 1e9f); });
    });
    const auto& row = row_of(report, Stage::collide, Slot::next_velocities);
    CHECK(row.beyond_bound == 2);
    CHECK(row.max_ulp == 1);
}
