// The arithmetic behind the panels: slider ends, units, grouped digits, the bars of the histogram.
#include <numeric>

#include "support/catch.h"
#include "ui/occupancy_panel.h"
#include "ui/setting_row.h"
#include "ui/widgets.h"

using namespace ballpit;

TEST_CASE("slider ends lie inside the setting's range and hold the scene's own value", "[ui]") {
    Settings defaults;
    defaults.balls = 5000;
    for (const double scale : {1e-6, 1.0, 1e6}) {
        defaults.stiffness = std::min(1000.0 * scale, 1e8);
        for (const SettingInfo& info : setting_table()) {
            const ui::SliderRange range = ui::slider_range(info, defaults, maximum_balls);
            INFO(info.key);
            CHECK(range.low >= info.minimum);
            CHECK(range.high <= info.maximum);
            CHECK(range.low <= range.high);
            CHECK((!range.logarithmic || range.low > 0.0));
        }
        const ui::SliderRange stiffness = ui::slider_range(*find_setting("stiffness"), defaults, maximum_balls);
        CHECK(stiffness.low <= defaults.stiffness);
        CHECK(stiffness.high >= defaults.stiffness);
    }
}

TEST_CASE("a scene that lists its balls has no slider beyond them", "[ui]") {
    Settings defaults;
    defaults.balls = 2;
    const ui::SliderRange range = ui::slider_range(*find_setting("balls"), defaults, 2);
    CHECK(range.low == 0.0);
    CHECK(range.high == 2.0);
    CHECK_FALSE(range.logarithmic);
}

TEST_CASE("a law that starts at zero can be slid to", "[ui]") {
    Settings defaults;
    defaults.drag = 0.0;
    const ui::SliderRange range = ui::slider_range(*find_setting("drag"), defaults, maximum_balls);
    CHECK(range.low > 0.0);
    CHECK(range.high == find_setting("drag")->maximum);
}

TEST_CASE("units are shown as written by hand", "[ui]") {
    CHECK(ui::shown_unit("m/s^2") == "m/s²");
    CHECK(ui::shown_unit("kg/m^3") == "kg/m³");
    CHECK(ui::shown_unit("N/m") == "N/m");
    CHECK(ui::shown_unit("%") == "%%");
    CHECK(ui::shown_unit("") == "");
}

TEST_CASE("digits are grouped in threes", "[ui]") {
    CHECK(ui::grouped(0) == "0");
    CHECK(ui::grouped(999) == "999");
    CHECK(ui::grouped(1000) == "1\u2009000");
    CHECK(ui::grouped(4194304) == "4\u2009194\u2009304");
}

TEST_CASE("histogram bars: one a count while they fit, doubling where they do not, no cell lost", "[ui]") {
    CHECK(ui::histogram_bars({}, 16).empty());
    const std::vector<std::uint32_t> only_empty = {12};
    CHECK(ui::histogram_bars(only_empty, 16).empty());

    for (const std::size_t longest : {1u, 2u, 15u, 16u, 17u, 64u, 1000u}) {
        std::vector<std::uint32_t> histogram(longest + 1);
        std::iota(histogram.begin(), histogram.end(), 3u);
        const auto bars = ui::histogram_bars(histogram, 16);
        INFO("longest " << longest);
        std::uint64_t cells = 0;
        std::uint32_t next = 1;
        for (const ui::HistogramBar& bar : bars) {
            CHECK(bar.first == next);
            next = bar.last + 1;
            cells += bar.cells;
        }
        CHECK(next == longest + 1);
        CHECK(cells == std::accumulate(histogram.begin() + 1, histogram.end(), std::uint64_t{0}));
        CHECK(bars.size() <= 16);
        CHECK((longest > 16 || bars.size() == longest));
    }
}
