// Scene files that are refused: one sentence with file, place, expectation and finding.
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/scene_file.h"
#include "support/catch.h"
#include "support/scene_text.h"
#include "support/temporary_folder.h"

using namespace ballpit;
using test::complaint;
using test::complaint_about_laws;
using test::scene_with;

namespace {

struct Refusal {
    std::string part, replacement, sentence;
};

}  // namespace

TEST_CASE("broken JSON is refused with line and column", "[core]") {
    CHECK(complaint("") == "s.json, line 1, column 1: expected JSON, found an empty file");
    CHECK(complaint("{\n  \"name\": nope }")
              .starts_with("s.json, line 2, column 12: expected JSON, found invalid literal"));
    CHECK(
        complaint("{\"name\": \"N\",}").starts_with("s.json, line 1, column 14: expected JSON, found unexpected '}'"));
    CHECK(complaint("{\"name\": \"N\"").find(": expected JSON, found unexpected end of input") != std::string::npos);
    CHECK(complaint("{\"name\": \"N\"} x")
              .starts_with("s.json, line 1, column 15: expected JSON, found invalid literal"));
    CHECK(complaint("{\"\u00e9\": NaN}").starts_with("s.json, line 1, column 7: expected JSON, found invalid literal"));
    CHECK(complaint("{\"name\": -Infinity}")
              .starts_with("s.json, line 1, column 11: expected JSON, found invalid number"));
    CHECK(complaint("[1e999]").starts_with(
        "s.json, line 1, column 6: expected JSON, found number overflow parsing '1e999'"));
    CHECK(complaint("{\"a\": \"\n\"}").starts_with("s.json, line 1, column 8: expected JSON, found invalid string"));
}

TEST_CASE("text that is not UTF-8 is refused where it begins", "[core]") {
    for (const std::string bad : {"\xff", "\xc3", "\xc3(", "\xe0\x80\x80", "\xed\xa0\x80", "\xf5\x80\x80\x80", "\x80",
                                  "\xf0\x8f\xbf\xbf", "\xe2\x82"}) {
        CHECK(complaint("{\"name\":\n \"" + bad) ==
              "s.json, line 2, column 3: expected UTF-8 text, found a byte that is not");
    }
}

TEST_CASE("a key twice and deep nesting are refused, also where no crash would show", "[core]") {
    CHECK(complaint(R"({"name": "A", "name": "B"})") == "s.json, /name: expected every key once, found this one twice");
    CHECK(complaint(R"("mass": 2)", R"("mass": 2, "mass": 3)") ==
          "s.json, /balls/0/mass: expected every key once, found this one twice");
    CHECK(complaint(R"({"a/b~": {}, "a/b~": {}})") == "s.json, /a~1b~0: expected every key once, found this one twice");
    const std::string deep(100000, '[');
    CHECK(complaint(deep).ends_with(": expected at most 16 levels of nesting, found more"));
    CHECK(complaint(R"({"name":)" + deep).ends_with(": expected at most 16 levels of nesting, found more"));
}

TEST_CASE("every bad value is refused in one sentence", "[core]") {
    const std::array refusals = {
        Refusal{R"("name": "N",)", "", "s.json: expected a key 'name', found none"},
        Refusal{R"("name": "N")", R"("name": "")", R"(s.json, /name: expected a name, found "")"},
        Refusal{R"("name": "N")", R"("name": 3)", "s.json, /name: expected text, found 3"},
        Refusal{R"("about": "A.")", R"("about": ["A."])", "s.json, /about: expected text, found a list of 1"},
        Refusal{
            R"("about")", R"("abuot")",
            "s.json: expected no other keys than $schema, name, about, box, laws, time, compute, balls, fill, resume, "
            "bounds, found 'abuot'"},
        Refusal{R"("half_extent": [1, 2, 3], )", "", "s.json, /box: expected a key 'half_extent', found none"},
        Refusal{"[1, 2, 3],", "[1, 2],",
                "s.json, /box/half_extent: expected a list of three numbers, found a list of 2"},
        Refusal{"[1, 2, 3],", "2,", "s.json, /box/half_extent: expected a list of three numbers, found 2"},
        Refusal{"[1, 2, 3],", "[1, 2, null],", "s.json, /box/half_extent/2: expected a number, found null"},
        Refusal{"[1, 2, 3],", "[1, 2, 0],",
                "s.json, /box/half_extent/2: expected a number from 0.001 to 10000 m, found 0"},
        Refusal{"[1, 2, 3],", "[1, -2, 3],",
                "s.json, /box/half_extent/1: expected a number from 0.001 to 10000 m, found -2"},
        Refusal{"[1, 2, 3],", "[1e5, 2, 3],",
                "s.json, /box/half_extent/0: expected a number from 0.001 to 10000 m, found 100000.0"},
        Refusal{R"("reference_count": 10)", R"("reference_count": -1)",
                "s.json, /box/reference_count: expected a whole number from 0 to 4194304, found -1"},
        Refusal{R"("reference_count": 10)", R"("reference_count": 2.5)",
                "s.json, /box/reference_count: expected a whole number from 0 to 4194304, found 2.5"},
        Refusal{R"("reference_count")", R"("reference")",
                "s.json, /box: expected no other keys than half_extent, reference_count, walls_low, walls_high, "
                "wall_speed, "
                "found 'reference'"},
        Refusal{R"("gravity")", R"("gravty")",
                "s.json, /laws: expected no other keys than gravity, drag, contact, walls, shake, diagnostics, "
                "compensated, found "
                "'gravty'"},
        Refusal{"[0, 0, -9.8]", "[0, 0, -980]",
                "s.json, /laws/gravity/2: expected a number from -100 to 100 m/s^2, found -980"},
        Refusal{"[0, 0, -9.8]", "-9.8", "s.json, /laws/gravity: expected a list of three numbers, found -9.8"},
        Refusal{R"("drag": 0.1)", R"("drag": -0.1)",
                "s.json, /laws/drag: expected a number from 0 to 100 1/s, found -0.1"},
        Refusal{R"("drag": 0.1)", R"("drag": "much")", R"(s.json, /laws/drag: expected a number, found "much")"},
        Refusal{R"("stiffness": 1000, )", "", "s.json, /laws/contact: expected a key 'stiffness', found none"},
        Refusal{R"("stiffness": 1000)", R"("stiffness": 1e9)",
                "s.json, /laws/contact/stiffness: expected a number from 0 to 1e+08 N/m, found 1e+09"},
        Refusal{R"("restitution": 0.9)", R"("restitution": 0.01)",
                "s.json, /laws/contact/restitution: expected a number from 0.05 to 1, found 0.01"},
        Refusal{R"("restitution": 0.9)", R"("restitution": 1.5)",
                "s.json, /laws/contact/restitution: expected a number from 0.05 to 1, found 1.5"},
        Refusal{R"("limit_force": true)", R"("limit_force": 1)",
                "s.json, /laws/contact/limit_force: expected true or false, found 1"},
        Refusal{R"("limit_force")", R"("limit")",
                "s.json, /laws/contact: expected no other keys than stiffness, restitution, limit_force, dashpot, "
                "found 'limit'"},
        Refusal{R"("walls": true)", R"("walls": "yes")", R"(s.json, /laws/walls: expected true or false, found "yes")"},
        Refusal{R"("walls": true)", R"("walls": { "stiffness": 1 })",
                "s.json, /laws/walls: expected true or false, because 'contact' says how stiff the walls are, found an "
                "object"},
        Refusal{R"("walls": true)", R"("shake": { "amplitude": [0, 0, 1], "frequency": 1 })",
                "s.json, /laws/shake: expected a law 'walls' beside 'shake', found none"},
        Refusal{R"("walls": true)", R"("walls": true, "shake": { "amplitude": [0, 0, 1] })",
                "s.json, /laws/shake: expected a key 'frequency', found none"},
        Refusal{R"("walls": true)", R"("walls": true, "shake": { "amplitude": [0, 0, 11], "frequency": 1 })",
                "s.json, /laws/shake/amplitude/2: expected a number from -10 to 10 m, found 11"},
        Refusal{R"("walls": true)", R"("diagnostics": 1)",
                "s.json, /laws/diagnostics: expected true or false, found 1"},
        Refusal{R"("reference_count": 10)", R"("walls_low": [0, 0, 101])",
                "s.json, /box/walls_low/2: expected a number from -100 to 100 m, found 101"},
        Refusal{R"("reference_count": 10)", R"("wall_speed": 0)",
                "s.json, /box/wall_speed: expected a number from 0.001 to 100 m/s, found 0"},
        Refusal{R"("time": {)", R"("compute": { "sort": "quick" }, "time": {)",
                R"(s.json, /compute/sort: expected one of bitonic, bitonic_fused, counting, auto, found "quick")"},
        Refusal{R"("time": {)", R"("compute": { "neighbors": "grid" }, "time": {)",
                "s.json, /compute: expected no other keys than sort, cell_factor, grid_reuse, neighbours, "
                "sorted_copies, keep_order, found "
                "'neighbors'"},
        Refusal{R"("time": {)", R"("bounds": { "overlap": 1 }, "time": {)",
                "s.json, /bounds: expected a key 'speed', found none"},
        Refusal{R"("time": {)", R"("bounds": { "speed": -1 }, "time": {)",
                "s.json, /bounds/speed: expected a number from 0 to 1e+06 m/s, found -1"},
        Refusal{R"("time": {)", R"("resume": { "step": -1 }, "time": {)",
                "s.json, /resume/step: expected a whole number from 0 to 18446744073709551615, found -1"},
        Refusal{R"("time": {)", R"("resume": { "velocity_lag": 2 }, "time": {)",
                "s.json, /resume/velocity_lag: expected a number from 0 to 1 s, found 2"},
        Refusal{R"("name": "N")", R"("$schema": 3, "name": "N")", "s.json, /$schema: expected text, found 3"},
        Refusal{R"("dt": 0.01)", R"("dt": 2)", "s.json, /time/dt: expected a number from 0 to 1 s, found 2"},
        Refusal{R"("substeps": 4)", R"("substeps": 0)",
                "s.json, /time/substeps: expected a number from 1 to 1024, found 0"},
        Refusal{R"("substeps": 4)", R"("substeps": 4.5)",
                "s.json, /time/substeps: expected a whole number from 0 to 4294967295, found 4.5"},
        Refusal{R"("historical")", R"("euler")",
                "s.json, /time/integrator: expected one of leapfrog, symplectic_euler, velocity_verlet, forward_euler, "
                "historical, found \"euler\""},
        Refusal{R"("dt")", R"("Dt")",
                "s.json, /time: expected no other keys than dt, substeps, integrator, found 'Dt'"},
        Refusal{R"("position": [0, 0, 1], )", "", "s.json, /balls/0: expected a key 'position', found none"},
        Refusal{R"("position": [0, 0, 1])", R"("position": [0, 0, 3.5])",
                "s.json, /balls/0/position/2: expected a place inside the box, from -3 to 3 m, found 3.5"},
        Refusal{R"("position": [0, 0, 1])", R"("position": [0, "0", 1])",
                R"(s.json, /balls/0/position/1: expected a number, found "0")"},
        Refusal{R"("velocity": [1, 0, 0])", R"("velocity": [1e30, 0, 0])",
                "s.json, /balls/0/velocity/0: expected a number from -1e+06 to 1e+06 m/s, found 1e+30"},
        Refusal{R"("radius": 0.5, )", "", "s.json, /balls/0: expected a key 'radius', found none"},
        Refusal{R"("radius": 0.5)", R"("radius": -0.5)",
                "s.json, /balls/0/radius: expected a number from 0.001 to 10000 m, found -0.5"},
        Refusal{R"("mass": 2)", R"("mass": -2)",
                "s.json, /balls/0/mass: expected a number from 1e-12 to 1e+19 kg, found -2"},
        Refusal{R"("mass": 2)", R"("mass": 0)",
                "s.json, /balls/0/mass: expected a number from 1e-12 to 1e+19 kg, found 0"},
        Refusal{R"("restitution": 0.8)", R"("restitution": 2)",
                "s.json, /balls/0/restitution: expected a number from 0.05 to 1, found 2"},
        Refusal{R"("mass": 2)", R"("weight": 2)",
                "s.json, /balls/0: expected no other keys than position, velocity, radius, mass, restitution, "
                "compensation, quarantined, found "
                "'weight'"},
        Refusal{R"("count": 7, )", "", "s.json, /fill: expected a key 'count', found none"},
        Refusal{R"("count": 7)", R"("count": 4194304)",
                "s.json, /fill/count: expected a whole number from 0 to 4194303, found 4194304"},
        Refusal{R"("count": 7)", R"("count": 1e3)",
                "s.json, /fill/count: expected a whole number from 0 to 4194303, found 1000.0"},
        Refusal{"[0.1, 0.2]", "[0.2, 0.1]",
                "s.json, /fill/radius/1: expected a largest radius not below the smallest, 0.2 m, found 0.1"},
        Refusal{"[0.1, 0.2]", "[0, 0.1]", "s.json, /fill/radius/0: expected a number from 0.001 to 10000 m, found 0"},
        Refusal{"[0.1, 0.2]", "[0.1]",
                "s.json, /fill/radius: expected a list of the smallest and the largest radius, found a list of 1"},
        Refusal{"[0.1, 0.2]", "0.1", "s.json, /fill/radius: expected a list, found 0.1"},
        Refusal{R"("density": 500)", R"("density": 0)",
                "s.json, /fill/density: expected a number from 0.001 to 1e+06 kg/m^3, found 0"},
        Refusal{R"("speed": 3)", R"("speed": -3)",
                "s.json, /fill/speed: expected a number from 0 to 1e+06 m/s, found -3"},
        Refusal{"[[-1, -2, 0], [1, 2, 3]]", "[[-1, -2, 3], [1, 2, 0]]",
                "s.json, /fill/region/1/2: expected an upper corner not below the lower one's 3 m, found 0"},
        Refusal{"[[-1, -2, 0], [1, 2, 3]]", "[[-1, -2, 0], [1, 2, 4]]",
                "s.json, /fill/region/1/2: expected a place inside the box, from -3 to 3 m, found 4"},
        Refusal{"[[-1, -2, 0], [1, 2, 3]]", "[[-1, -2, 0]]",
                "s.json, /fill/region: expected a list of two corners, found a list of 1"},
        Refusal{R"("seed": 42)", R"("seed": -42)",
                "s.json, /fill/seed: expected a whole number from 0 to 18446744073709551615, found -42"},
        Refusal{
            R"("seed": 42)", R"("seed": 18446744073709551616)",
            "s.json, /fill/seed: expected a whole number from 0 to 18446744073709551615, found 1.8446744073709552e+19"},
        Refusal{R"("seed": 42)", R"("sead": 42)",
                "s.json, /fill: expected no other keys than count, radius, density, speed, region, seed, found 'sead'"},
    };
    for (const Refusal& refusal : refusals) {
        CAPTURE(refusal.part, refusal.replacement);
        CHECK(complaint(refusal.part, refusal.replacement) == refusal.sentence);
    }
}

TEST_CASE("parts that contradict each other are refused", "[core]") {
    CHECK(complaint("[1, 2]") == "s.json: expected an object, found a list of 2");
    CHECK(complaint("null") == "s.json: expected an object, found null");
    CHECK(complaint(R"({"name": "N", "box": {"half_extent": [1, 1, 1]}})") ==
          "s.json: expected 'balls' or 'fill', found neither");
    CHECK(complaint(R"({"name": "N", "box": {"half_extent": [1, 1, 1]}, "balls": []})") ==
          "s.json: expected 'balls' or 'fill', found neither");
    CHECK(complaint(R"({"name": "N", "box": {"half_extent": [1, 1, 1]}, "laws": {"walls": true}})") ==
          "s.json, /laws/walls: expected a law 'contact', whose stiffness walls share, or their own as "
          "{ \"stiffness\": N/m }, found neither");
    CHECK(complaint_about_laws(R"("walls": 1)") == "s.json, /laws/walls: expected true or false, found 1");
    CHECK(complaint_about_laws(R"("walls": {})") == "s.json, /laws/walls: expected a key 'stiffness', found none");
    CHECK(complaint_about_laws(R"("shake": {"amplitude": [0, 0, 1], "frequency": 1}, "walls": false)") ==
          "s.json, /laws/shake: expected a law 'walls' beside 'shake', found none");
    CHECK(complaint(R"({"name": "N", "box": {"half_extent": [1, 1, 1]},
                        "balls": [{"position": [0, 0, 0], "radius": 1, "mass": 1, "restitution": 0.5}]})") ==
          "s.json, /balls/0/restitution: expected a law 'contact' or 'walls' beside a ball's restitution, found none");
}

TEST_CASE("a ball may stick out of the box as long as its centre is inside", "[core]") {
    CHECK(complaint("[0, 0, 1]", "[1, 2, 3]") == "accepted");
}

TEST_CASE("long values are quoted short, and on one line", "[core]") {
    const std::string sentence = complaint(R"("drag": 0.1)", R"("drag": ")" + std::string(100000, 'x') + R"(\n")");
    CHECK(sentence.size() < 200);
    CHECK(complaint(R"("drag")", "\"a\u007f\\n\"").ends_with(R"(found 'a\x7F\x0A')"));
    const std::string long_key = complaint(R"("drag": 0.1)", '"' + std::string(1000, 'k') + R"(": {"a": 1, "a": 1})");
    CHECK(long_key.size() < 250);
    CHECK(complaint(R"("drag": 0.1)", R"("drag": 1e)" + std::string(1000, '9')).size() < 250);
    CHECK(complaint(R"("drag": 0.1)", R"("drag": "a\nb")") == R"(s.json, /laws/drag: expected a number, found "a\nb")");
}

TEST_CASE("a file that cannot be read is refused by name", "[core]") {
    const test::TemporaryFolder folder;
    const auto complaint_about = [](const std::filesystem::path& path) {
        return test::complaint_of([&] { load_scene(path); });
    };
    const auto missing = folder.path() / "missing.json";
    CHECK(complaint_about(missing) == missing.string() + ": expected a scene file, found none that can be read");
    CHECK(complaint_about(folder.path()) == folder.path().string() + ": expected a scene file, found a folder");
    const auto huge = folder.path() / "huge.json";
    std::ofstream(huge) << ' ';
    std::filesystem::resize_file(huge, (std::uintmax_t{1} << 30) + 1);
    CHECK(complaint_about(huge) == huge.string() + ": expected a scene file of at most 1 GiB, found a larger one");
    const auto good = folder.path() / "good.json";
    std::ofstream(good) << scene_with("N", "N");
    CHECK(load_scene(good).name == "N");
}
