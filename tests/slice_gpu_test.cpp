// The slice through the grid with its numbers, and the selected cell, pixel by pixel.
#include <cmath>

#include "support/catch.h"
#include "support/gl_fixture.h"
#include "support/studio.h"

using namespace ballpit;
using namespace ballpit::test;

TEST_CASE_METHOD(GlFixture, "a slice shows the cells of its layer, coloured by count, and no others", "[view]") {
    Inside studio;
    studio.picture.top_count = 5;
    studio.set_counts({{{0, 1, 0}, 1}, {{3, 1, 3}, 5}, {{2, 2, 0}, 5}});
    studio.picture.show_cells = true;
    const Pixels bare = [&] {
        studio.picture.show_cells = false;
        const Pixels pixels = studio.draw();
        studio.picture.show_cells = true;
        return pixels;
    }();
    studio.overlay.slice = GridSlice{1, 1};
    const Pixels drawn = studio.draw();
    const float face = -0.5f;  // layer 1 reaches from -0.5 to 0; its side towards the eye
    const auto cell = [&](int x, int z) {
        return vec3(-1.0f + 0.5f * static_cast<float>(x) + 0.06f, face, -1.0f + 0.5f * static_cast<float>(z) + 0.06f);
    };
    const vec3 one = studio.at(drawn, cell(0, 0));
    const vec3 five = studio.at(drawn, cell(3, 3));
    CHECK(one.z > one.x + 60.0f);                                        // blue
    CHECK(five.x > five.z + 60.0f);                                      // yellow
    CHECK(studio.at(drawn, cell(2, 0)) == studio.at(bare, cell(2, 0)));  // of the next layer
    const float nearest = 4.5f * std::tan(0.5f * studio.picture.camera.field_of_view);
    const auto x_of = [&](float x) { return static_cast<int>(160.0f + 120.0f * x / nearest); };
    const std::vector<bool> mask = changed(bare, drawn);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const bool inside = x >= x_of(-1.0f) - 1 && x <= x_of(1.01f) + 1;
            REQUIRE((!mask[static_cast<std::size_t>(y * width + x)] || inside));
        }
    }
    CHECK(mask[static_cast<std::size_t>(60 * width + x_of(-0.5f))]);  // outline of empty cells
    // Beyond the grid, or without cells, there is nothing to show.
    for (const GridSlice& nothing : {GridSlice{1, 4}, GridSlice{3, 0}, GridSlice{-1, 0}}) {
        studio.overlay.slice = nothing;
        CHECK(studio.draw() == bare);
    }
    studio.overlay.slice = GridSlice{1, 1};
    studio.picture.cell_ranges = nullptr;
    CHECK(studio.draw() == bare);
}

TEST_CASE_METHOD(GlFixture, "a slice across each axis takes its own cells, from either side", "[view]") {
    Inside studio;
    studio.picture.top_count = 2;
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.0f, 1.0f}) {
            uvec3 cell{3, 2, 0};
            studio.set_counts({{cell, 1}});
            studio.picture.camera = home(studio.picture.half_extent);
            const vec3 away = axis == 0   ? vec3(side, 0.2f, 0.3f)
                              : axis == 1 ? vec3(0.3f, side, 0.2f)
                                          : vec3(0.2f, 0.3f, side);
            const vec3 to_centre = -glm::normalize(away);
            studio.picture.camera.yaw = std::atan2(to_centre.y, to_centre.x);
            studio.picture.camera.pitch = std::asin(to_centre.z);
            studio.picture.camera.position = -5.0f * to_centre;
            studio.overlay.slice.reset();
            const Pixels bare = studio.draw();
            studio.overlay.slice = GridSlice{axis, cell[axis]};
            const Pixels drawn = studio.draw();
            vec3 middle = -1.0f + 0.5f * (vec3(cell) + 0.5f);
            middle[axis] += 0.25f * side;
            const vec3 corner = middle + 0.17f * (axis == 0   ? vec3(0, 1, 1)
                                                  : axis == 1 ? vec3(1, 0, 1)
                                                              : vec3(1, 1, 0));
            CAPTURE(axis, side);
            const vec3 colour = studio.at(drawn, corner);
            CHECK(colour.z > colour.x + 60.0f);
            CHECK(near_to(studio.at(drawn, -middle), studio.at(bare, -middle), 60.0f));
            studio.overlay.slice->layer = (cell[axis] + 1) % 4;
            const vec3 elsewhere = studio.at(studio.draw(), corner);
            CHECK(elsewhere.z < elsewhere.x + 60.0f);
        }
    }
}

TEST_CASE_METHOD(GlFixture, "a cell large enough carries its number, upright", "[view]") {
    Inside studio;
    studio.picture.camera.position = {-0.75f, -2.2f, -0.75f};
    const auto dark = [](const vec3& pixel) { return pixel.x + pixel.y + pixel.z < 180.0f; };
    // 7: the upper row and the right column of its dots are dark, the lower left corner is not.
    for (const float side : {1.0f, -1.0f}) {
        studio.picture.camera.position.y = -2.2f * side;
        studio.picture.camera.yaw = side * 0.5f * half_turn;
        studio.set_counts({{{0, 0, 0}, 7}, {{0, 3, 0}, 7}});
        studio.overlay.slice = GridSlice{1, side > 0.0f ? 0u : 3u};
        const Pixels drawn = studio.draw();
        const auto dot = [&](float column, float row) {
            const float to_right = side * 0.25f * 0.6f * (column - 1.0f) / 3.0f;
            return studio.at(drawn, vec3(-0.75f + to_right, -side, -0.75f - 0.25f * (row - 2.0f) / 5.0f));
        };
        for (const float column : {0.0f, 1.0f, 2.0f}) {
            CHECK(dark(dot(column, 0)));
        }
        for (const float row : {1.0f, 2.0f, 3.0f, 4.0f}) {
            CHECK(dark(dot(2, row)));
            CHECK_FALSE(dark(dot(0, row)));
        }
    }
}

TEST_CASE_METHOD(GlFixture, "a slice that cuts away leaves out what stands before its layer", "[view]") {
    Inside studio;
    studio.set_counts({});
    const vec4 before{0.1f, -0.7f, 0.1f, 0.15f};
    const vec4 within{-0.4f, -0.25f, 0.1f, 0.15f};
    studio.overlay.slice = GridSlice{1, 1, false};
    for (const Look look : looks) {
        studio.picture.look = look;
        studio.set_balls({within});
        const Pixels without = studio.draw();
        studio.set_balls({within, before});
        CHECK(studio.draw() != without);
        studio.overlay.slice->cut_away = true;
        CHECK(studio.draw() == without);
        studio.overlay.highlights = {{1, vec4(1, 0, 0, 0)}};  // a ball that somebody follows stays
        CHECK(studio.draw() != without);
        studio.overlay.highlights.clear();
        studio.overlay.slice->cut_away = false;
        studio.overlay.fade_others = 0.5f;
        studio.set_balls({within});
        const Pixels faded = studio.draw();
        studio.set_balls({within, before});
        CHECK(studio.draw() != faded);
        studio.overlay.slice->cut_away = true;
        CHECK(studio.draw() == faded);
        studio.overlay.slice->cut_away = false;
        studio.overlay.fade_others = 0.0f;
    }
}

TEST_CASE_METHOD(GlFixture, "the selected cell is outlined strongly, also behind balls", "[view]") {
    Inside studio;
    const Pixels bare = studio.draw();
    studio.overlay.cell = (1 * 4 + 0) * 4 + 2;  // cell (2, 0, 1)
    const Pixels drawn = studio.draw();
    CHECK(near_to(studio.at(drawn, vec3(0.25f, -1.0f, -0.5f)), vec3(255), 6.0f));
    CHECK(near_to(studio.at(drawn, vec3(0.5f, -1.0f, -0.25f)), vec3(255), 6.0f));
    CHECK(studio.at(drawn, vec3(0.25f, -1.0f, -0.25f)) == studio.at(bare, vec3(0.25f, -1.0f, -0.25f)));
    studio.overlay.cell = 64;
    CHECK(studio.draw() == bare);
}
