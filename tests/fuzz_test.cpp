// Can each property of the fuzz fail? Every one gets a planted violation; and what fails is made small.
#include <limits>
#include <memory>
#include <set>
#include <string>

#include "cpu/cpu_backend.h"
#include "support/balls.h"
#include "support/catch.h"
#include "support/fuzz_properties.h"
#include "support/fuzz_run.h"
#include "support/fuzz_shrink.h"
#include "support/input_error.h"

using namespace ballpit;
using namespace ballpit::test;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

std::string text_of(const Complaint& complaint) { return complaint.value_or("none"); }
bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// A substep in which nothing happens to two balls that touch.
SeenSubstep quiet_substep() {
    SeenSubstep seen;
    seen.before.positions = {vec4(0, 0, 0, 0.1f), vec4(0.15f, 0, 0, 0.1f)};
    seen.before.velocities = {vec4(0, 0, 0, 1), vec4(0, 0, 0, 2)};
    seen.after = seen.before;
    seen.features.add(Feature::contact);
    seen.features.add(Feature::walls);
    seen.features.add(Feature::diagnostics);
    seen.assigned = true;
    seen.params.stiffness = 1000.0;
    seen.params.drift = 1e-3;
    seen.params.gain = 1e-3;
    seen.params.box_lower = dvec3(-1.0);
    seen.params.box_upper = dvec3(1.0);
    return seen;
}

FuzzBackends mirror() {
    return {[] { return std::make_unique<cpu::CpuBackend<float>>(); }, nullptr, nullptr};
}

// A mirror that does `spoil` to its next state in every substep.
class SpoilingBackend : public cpu::CpuBackend<float> {
public:
    explicit SpoilingBackend(std::function<void(SpoilingBackend&)> spoil) : spoil_(std::move(spoil)) {}
    void run(const Schedule& schedule, const SubstepParams<double>& params, std::size_t first,
             std::size_t last) override {
        CpuBackend<float>::run(schedule, params, first, last);
        if (last == schedule.dispatches.size() && schedule.ball_count > 0) {
            in_place = schedule.in_place;
            spoil_(*this);
        }
    }
    template <class Change>
    void change(Slot slot, const Change& change) {
        auto values = read_slot<vec4>(*this, slot);
        change(values);
        write(slot, std::as_bytes(std::span(values)));
    }
    Slot positions() const { return in_place ? Slot::positions : Slot::next_positions; }
    Slot velocities() const { return in_place ? Slot::velocities : Slot::next_velocities; }
    bool in_place = false;

private:
    std::function<void(SpoilingBackend&)> spoil_;
};

FuzzBackends spoiling(const std::function<void(SpoilingBackend&)>& spoil) {
    return {[spoil] { return std::make_unique<SpoilingBackend>(spoil); }, nullptr, nullptr};
}

// Properties that some of the first cases break.
std::set<std::string> broken_by(const FuzzBackends& backends, std::uint64_t cases = 60) {
    std::set<std::string> properties;
    FuzzTally tally;
    for (std::uint64_t i = 0; i < cases; ++i) {
        if (const auto failure = run_fuzz_case(make_fuzz_case(3, i), backends, tally)) {
            properties.insert(failure->property);
        }
    }
    return properties;
}

}  // namespace

TEST_CASE("a substep in which nothing happens breaks no property", "[fuzz]") {
    const SeenSubstep seen = quiet_substep();
    CHECK(text_of(balls_exchanged(seen)) == "none");
    CHECK(text_of(lost_in_silence(seen)) == "none");
    CHECK(text_of(lost_without_cause(seen)) == "none");
    CHECK(text_of(outside_in_silence(seen)) == "none");
}

TEST_CASE("balls that are gone, or have another radius or mass, are noticed", "[fuzz]") {
    SeenSubstep seen = quiet_substep();
    seen.after.positions.pop_back();
    CHECK(text_of(balls_exchanged(seen)) == "2 balls became 1");
    seen = quiet_substep();
    seen.after.positions[1].w = 0.2f;
    CHECK(text_of(balls_exchanged(seen)) == "ball 1 has another radius");
    seen = quiet_substep();
    seen.after.velocities[0].w = 2.0f;
    CHECK(text_of(balls_exchanged(seen)) == "ball 0 has another mass");
    seen = quiet_substep();
    seen.after.positions[1].w = -0.1f;  // into quarantine
    CHECK(text_of(balls_exchanged(seen)) == "none");
    std::swap(seen.before, seen.after);  // and out of it
    CHECK(text_of(balls_exchanged(seen)) == "ball 1 has another radius");
}

TEST_CASE("balls that are lost in silence are noticed", "[fuzz]") {
    SeenSubstep seen = quiet_substep();
    seen.after.positions[1].y = not_a_number;
    CHECK(text_of(lost_in_silence(seen)) == "ball 1 is not finite");
    seen = quiet_substep();
    seen.after.positions[1].w = -0.1f;
    CHECK(text_of(lost_in_silence(seen)) == "1 balls are newly in quarantine, 0 were counted");
    seen.status_after.not_finite = 1;
    CHECK(text_of(lost_in_silence(seen)) == "none");
    seen.status_after.not_finite = 2;
    CHECK(text_of(lost_in_silence(seen)) != "none");
}

TEST_CASE("a ball is lost without cause where no force could have carried it away", "[fuzz]") {
    SeenSubstep seen = quiet_substep();
    seen.after.velocities[0].x = not_a_number;
    CHECK(contains(text_of(lost_without_cause(seen)), "ball 0 is lost"));
    seen.params.stiffness = 1e38;  // such a spring could
    CHECK(text_of(lost_without_cause(seen)) == "none");
    seen = quiet_substep();
    seen.after.positions[1].w = -0.1f;
    CHECK(contains(text_of(lost_without_cause(seen)), "ball 1 is lost"));
    seen.before.velocities[1].z = 1e30f;
    CHECK(text_of(lost_without_cause(seen)) == "none");
}

TEST_CASE("balls outside the box are counted, and no others", "[fuzz]") {
    SeenSubstep seen = quiet_substep();
    seen.before.positions[1].z = 1.01f;
    CHECK(text_of(outside_in_silence(seen)) == "1 balls are outside the box, 0 were counted");
    seen.status_after.out_of_bounds = 1;
    CHECK(text_of(outside_in_silence(seen)) == "none");
    seen.before.positions[1].z = 0.0f;
    CHECK(text_of(outside_in_silence(seen)) == "0 balls are outside the box, 1 were counted");
}

TEST_CASE("a pair that the grid misses is noticed", "[fuzz]") {
    const std::vector<vec4> positions = {vec4(-0.05f, 0.5f, 0.5f, 0.1f), vec4(0.05f, 0.5f, 0.5f, 0.1f)};
    const Grid grid{dvec3(-1.0), 0.2, uvec3(10)};
    const auto id = [](std::uint32_t x) { return (7 * 10 + 7) * 10 + x; };
    std::vector<Key> keys = {{id(4), 0}, {id(5), 1}};
    std::vector<CellRange> ranges(grid.cell_count());
    ranges[id(4)] = {0, 1};
    ranges[id(5)] = {1, 2};
    CHECK(text_of(pairs_missed({positions, keys, ranges, grid})) == "none");
    keys[1].cell_id = id(7);
    CHECK(text_of(pairs_missed({positions, keys, ranges, grid})) == "the grid finds 0 of 1 touching pairs");
}

TEST_CASE("energy that grows by itself is noticed, rounding is not", "[fuzz]") {
    measure::Totals start;
    start.kinetic = 10.0;
    measure::Totals now = start;
    CHECK(text_of(energy_grew(start, now)) == "none");
    now.kinetic = 14.0;
    CHECK(contains(text_of(energy_grew(start, now)), "grew from 10 J to 14 J"));
    CHECK(text_of(energy_grew(start, now, 1.0)) == "none");
    now.potential = -4.0;  // it fell
    CHECK(text_of(energy_grew(start, now)) == "none");
}

TEST_CASE("hashes of one moment must be the same", "[fuzz]") {
    CHECK(text_of(hashes_differ(1, 1)) == "none");
    CHECK(text_of(hashes_differ(1, 2)) != "none");
}

TEST_CASE("a case is a pure function of its numbers, and survives its file", "[fuzz]") {
    for (std::uint64_t i = 0; i < 200; ++i) {
        const FuzzCase fuzz_case = make_fuzz_case(5, i);
        const std::string text = case_text(fuzz_case);
        CAPTURE(i, text);
        CHECK(case_text(make_fuzz_case(5, i)) == text);
        const FuzzCase again = parse_case(text, "case.json");
        CHECK(case_text(again) == text);
        CHECK(again.actions == fuzz_case.actions);
        CHECK(again.substeps == fuzz_case.substeps);
        CHECK(again.seed == fuzz_case.seed);
    }
    CHECK(test::complaint_of([] {
              parse_case(R"({"name": "N", "about": "a", "box": {"half_extent": [1, 1, 1]}, "balls": [], "fill":
                         {"count": 0, "radius": [1, 1]}})",
                         "f");
          }) == "f, /about: expected 'property fuzz: N substeps, seed S', found 'a'");
}

TEST_CASE("a sound mirror breaks no property", "[fuzz]") { CHECK(broken_by(mirror(), 150).empty()); }

TEST_CASE("a mirror with a fault breaks the property that the fault is of", "[fuzz]") {
    CHECK(broken_by(spoiling([](SpoilingBackend& b) {
              b.change(b.velocities(), [](auto& v) { v[0].x = not_a_number; });
          })).contains("nothing is lost in silence"));
    CHECK(broken_by(spoiling([](SpoilingBackend& b) {
              b.change(b.positions(), [](auto& x) { x[0].w *= 1.5f; });
          })).contains("no ball is exchanged"));
    CHECK(broken_by(spoiling([](SpoilingBackend& b) {
              b.change(b.velocities(), [](auto& v) { v[0].y += 0.5f; });
          })).contains("momentum comes from outside"));
    CHECK(broken_by(spoiling([](SpoilingBackend& b) {
              static int calls = 0;  // another state in every run
              b.change(b.positions(), [](auto& x) { x[0].y += 1e-3f * static_cast<float>(++calls); });
          })).contains("a second run is the same"));
}

TEST_CASE("what fails is made small, and still fails", "[fuzz]") {
    FuzzCase large = make_fuzz_case(5, 0);
    large.scene = Scene{};
    large.scene.name = "large";
    large.scene.half_extent = {1.25, 2.5, 0.75};
    large.scene.settings.laws = parse_laws("gravity,drag,contact,walls,diagnostics");
    large.scene.settings.stiffness = 1234.5;
    for (int i = 0; i < 40; ++i) {
        large.scene.balls.push_back(
            {dvec3(0.01 * i, 0.1, 0.2), dvec3(1.5, i, 0.0), 0.1 + 0.001 * i, 2.5, std::nullopt});
    }
    large.scene.settings.balls = 40;
    large.substeps = 25;
    large.actions = {{3, "set drag=0.5"}, {7, "back step 2"}};
    // Fails as long as ball 17 is there and drag changes before the tenth substep.
    const auto fails = [](const FuzzCase& c) {
        const bool ball = std::ranges::any_of(c.scene.balls,
                                              [](const BallSpec& b) { return b.radius > 0.1165 && b.radius < 0.1175; });
        return ball && !c.actions.empty() && c.actions[0].text == "set drag=0.5" && c.substeps >= 10 &&
               c.scene.settings.laws.drag;
    };
    REQUIRE(fails(large));
    const FuzzCase small = shrunk(large, fails);
    CHECK(fails(small));
    CHECK(small.scene.balls.size() == 1);
    CHECK(small.substeps == 10);
    CHECK(small.actions.size() == 1);
    CHECK(small.scene.settings.laws == parse_laws("drag,diagnostics"));
    CHECK(small.scene.half_extent == dvec3(1.0));
    CHECK(small.scene.balls[0].velocity == dvec3(0.0));
    CHECK(case_text(parse_case(case_text(small), "small.json")) == case_text(small));
}
