// The table of settings: every row prints and parses, keeps its range, and refuses the rest in one sentence.
#include "core/settings.h"

#include <cmath>
#include <limits>
#include <set>

#include "core/error.h"
#include "support/catch.h"
#include "support/input_error.h"

using namespace ballpit;
using test::complaint_of;

namespace {

std::string complaint(std::string_view key, std::string_view text) {
    return complaint_of([&] {
        Settings settings;
        assign_setting(settings, key, text);
    });
}

Settings unusual_settings() {
    Settings s;
    s.balls = 4194304;
    s.gravity = {0.1, -1.0 / 3.0, 99.999};
    s.drag = 1e-300;
    s.stiffness = 12345.678901234567;
    s.restitution = 0.1 + 0.2;
    s.limit_force = false;
    s.dt = 1.0 / 90.0;
    s.substeps = 1024;
    s.integrator = Integrator::historical;
    s.sort = SortMethod::bitonic;
    s.cell_factor = 0.75;
    s.grid_reuse = 64;
    return s;
}

}  // namespace

TEST_CASE("keys are unique, and every row says what it is", "[core]") {
    std::set<std::string_view> keys;
    for (const SettingInfo& info : setting_table()) {
        CAPTURE(info.key);
        CHECK(keys.insert(info.key).second);
        CHECK(find_setting(info.key) == &info);
        CHECK_FALSE(info.label.empty());
        CHECK(info.about.ends_with('.'));
        CHECK(info.minimum <= info.maximum);
    }
    CHECK(find_setting("gravty") == nullptr);
}

TEST_CASE("every setting prints and parses to the same value", "[core]") {
    for (const Settings& original : {Settings{}, unusual_settings()}) {
        Settings copy;
        for (const SettingInfo& info : setting_table()) {
            assign_setting(copy, info.key, setting_text(info, original));
        }
        CHECK(copy == original);
    }
}

TEST_CASE("the default of every setting lies in its range", "[core]") {
    const Settings defaults;
    for (const SettingInfo& info : setting_table()) {
        Settings settings;
        CHECK_NOTHROW(assign_setting(settings, info.key, setting_text(info, defaults)));
    }
}

TEST_CASE("settings are printed as the command line takes them", "[core]") {
    const Settings defaults;
    CHECK(setting_text(*find_setting("substeps"), defaults) == "8");
    CHECK(setting_text(*find_setting("drag"), defaults) == "0.1");
    CHECK(setting_text(*find_setting("gravity"), defaults) == "0,0,-9.8");
    CHECK(setting_text(*find_setting("integrator"), defaults) == "leapfrog");
    CHECK(setting_text(*find_setting("sort"), defaults) == "bitonic_fused");
    CHECK(setting_text(*find_setting("limit_force"), defaults) == "true");
}

TEST_CASE("choices have names, other settings have none", "[core]") {
    CHECK(setting_choices(*find_setting("integrator")).size() == integrator_names.size());
    CHECK(setting_choices(*find_setting("sort")).size() == sort_names.size());
    CHECK(setting_choices(*find_setting("drag")).empty());
    for (const std::string_view name : integrator_names) {
        Settings settings;
        assign_setting(settings, "integrator", name);
        CHECK(setting_text(*find_setting("integrator"), settings) == name);
    }
}

TEST_CASE("a setting applies where its law is modelled", "[core]") {
    const Laws none;
    CHECK(setting_applies(*find_setting("substeps"), none));
    CHECK_FALSE(setting_applies(*find_setting("drag"), none));
    CHECK(setting_applies(*find_setting("drag"), parse_laws("drag")));
    CHECK_FALSE(setting_applies(*find_setting("stiffness"), none));
    CHECK(setting_applies(*find_setting("stiffness"), parse_laws("contact")));
    CHECK(setting_applies(*find_setting("stiffness"), parse_laws("walls")));
}

TEST_CASE("a bad value is refused with key, text and what was expected", "[core]") {
    CHECK(complaint("drag", "-1") == "setting 'drag' cannot be '-1': expected a number from 0 to 100 1/s");
    CHECK(complaint("drag", "1e999") == "setting 'drag' cannot be '1e999': expected a number from 0 to 100 1/s");
    CHECK(complaint("drag", "nan") == "setting 'drag' cannot be 'nan': expected a number from 0 to 100 1/s");
    CHECK(complaint("drag", "inf") == "setting 'drag' cannot be 'inf': expected a number from 0 to 100 1/s");
    CHECK(complaint("drag", "") == "setting 'drag' cannot be '': expected a number from 0 to 100 1/s");
    CHECK(complaint("drag", "0.1 ") == "setting 'drag' cannot be '0.1 ': expected a number from 0 to 100 1/s");
    CHECK(complaint("drag", "0,1") == "setting 'drag' cannot be '0,1': expected a number from 0 to 100 1/s");
    CHECK(complaint("balls", "-1") == "setting 'balls' cannot be '-1': expected a whole number from 0 to 4194304");
    CHECK(complaint("balls", "5e3") == "setting 'balls' cannot be '5e3': expected a whole number from 0 to 4194304");
    CHECK(complaint("balls", "99999999999") ==
          "setting 'balls' cannot be '99999999999': expected a whole number from 0 to 4194304");
    CHECK(complaint("substeps", "0") == "setting 'substeps' cannot be '0': expected a whole number from 1 to 1024");
    CHECK(complaint("gravity", "0,0") ==
          "setting 'gravity' cannot be '0,0': expected three numbers x,y,z, each from -100 to 100 m/s^2");
    CHECK(complaint("gravity", "0,0,-1000") ==
          "setting 'gravity' cannot be '0,0,-1000': expected a number from -100 to 100 m/s^2");
    CHECK(complaint("gravity", "0,0,0,0") ==
          "setting 'gravity' cannot be '0,0,0,0': expected a number from -100 to 100 m/s^2");
    CHECK(complaint("limit_force", "1") == "setting 'limit_force' cannot be '1': expected true or false");
    CHECK(complaint("integrator", "euler") ==
          "setting 'integrator' cannot be 'euler': expected one of leapfrog, symplectic_euler, velocity_verlet, "
          "forward_euler, historical");
    CHECK(complaint("sort", "") ==
          "setting 'sort' cannot be '': expected one of bitonic, bitonic_fused, counting, auto");
    CHECK(complaint("restitution", "0.01") ==
          "setting 'restitution' cannot be '0.01': expected a number from 0.05 to 1");
    CHECK(complaint("gravty", "1") == "there is no setting 'gravty': `ballpit settings` lists them");
}

TEST_CASE("a refused value leaves the settings as they were", "[core]") {
    Settings settings = unusual_settings();
    CHECK_THROWS_AS(assign_setting(settings, "gravity", "1,2,nan"), InputError);
    CHECK_THROWS_AS(assign_setting(settings, "balls", "4194305"), InputError);
    CHECK(settings == unusual_settings());
}

TEST_CASE("ranges include their ends and nothing beyond", "[core]") {
    const SettingInfo& drag = *find_setting("drag");
    CHECK_NOTHROW(check_range(drag, 0.0, "here"));
    CHECK_NOTHROW(check_range(drag, 100.0, "here"));
    CHECK(complaint_of([&] { check_range(drag, 100.5, "a.json, /laws/drag"); }) ==
          "a.json, /laws/drag: expected a number from 0 to 100 1/s, found 100.5");
    for (const double bad : {-1e-9, std::nextafter(100.0, 200.0), std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()}) {
        CHECK_THROWS_AS(check_range(drag, bad, "here"), InputError);
    }
}
