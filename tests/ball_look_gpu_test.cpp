// Balls that are see-through, coloured by value, or have arrows: pixel by pixel.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "support/catch.h"
#include "support/gl_fixture.h"
#include "support/studio.h"

using namespace ballpit;
using namespace ballpit::test;

TEST_CASE_METHOD(GlFixture, "faded balls are see-through, the nearest only; highlighted ones are not", "[view]") {
    Inside studio;
    const vec4 front{0, -0.5f, 0, 0.3f};
    const vec4 back{0, 0.6f, 0, 0.5f};
    const vec3 front_middle(front);
    for (const Look look : looks) {
        studio.picture.look = look;
        studio.overlay = {};
        studio.set_balls({});
        const Pixels none = studio.draw();
        studio.set_balls({front});
        const Pixels front_alone = studio.draw();
        studio.overlay.fade_others = 0.7f;
        const Pixels ghost = studio.draw();
        const vec3 expected = glm::mix(studio.at(front_alone, front_middle), studio.at(none, front_middle), 0.7f);
        CHECK(near_to(studio.at(ghost, front_middle), expected, 2.0f));
        studio.set_balls({front, back});
        CHECK(near_to(studio.at(studio.draw(), front_middle), expected, 2.0f));
        studio.overlay.fade_others = 1.0f;
        CHECK(studio.draw() == none);

        // The one behind is highlighted: whole, and seen through the ghost.
        studio.overlay.fade_others = 0.0f;
        studio.set_balls({vec4(5, 0, 0, 0.1f), back});  // so that it is ball 1
        studio.overlay.highlights = {{1, red}};
        const Pixels marked = studio.draw();
        studio.overlay.fade_others = 1.0f;
        studio.set_balls({front, back});
        CHECK(studio.draw() == marked);
        studio.overlay.highlights[0].colour.a = 0.0f;
        const vec3 whole = studio.at(studio.draw(), front_middle);
        studio.overlay.fade_others = 0.7f;
        const vec3 mixed = glm::mix(studio.at(front_alone, front_middle), whole, 0.7f);
        CHECK(near_to(studio.at(studio.draw(), front_middle), mixed, 2.0f));
    }
}

TEST_CASE_METHOD(GlFixture, "a faded ball has a fainter shadow", "[view]") {
    Inside studio;
    studio.picture.show_ground = studio.picture.show_shadows = true;
    studio.picture.grid.cell_width = 1.0;
    studio.picture.camera = home(studio.picture.half_extent);
    const auto darkness = [&](const Pixels& lit, const Pixels& pixels) {
        double sum = 0.0;
        for (std::size_t i = 0; i < lit.size(); ++i) {
            sum += std::max(0.0, static_cast<double>(lit[i]) - pixels[i]);
        }
        return sum;
    };
    const Pixels lit = studio.draw();
    studio.set_balls({vec4(0, 0, 0.8f, 0.4f)});
    studio.overlay.fade_others = 1e-3f;
    const double whole = darkness(lit, studio.draw());
    studio.overlay.fade_others = 0.5f;
    const double half = darkness(lit, studio.draw());
    studio.overlay.fade_others = 0.999f;
    CHECK(half < 0.75 * whole);
    CHECK(darkness(lit, studio.draw()) < 0.1 * half);
    // Nor does it darken the ground below it any more.
    studio.picture.show_shadows = false;
    studio.set_balls({vec4(0, 0, -0.5f, 0.4f)});
    const double no_ball = darkness(lit, studio.draw());
    studio.overlay.fade_others = 1e-3f;
    CHECK(no_ball < 0.1 * darkness(lit, studio.draw()));
}

TEST_CASE_METHOD(GlFixture, "an arrow points along the velocity, as long as the way in its time", "[view]") {
    Inside studio;
    const float scale = studio.pixels_a_metre();
    studio.set_balls({vec4(-0.5f, 0, 0, 0.2f)}, {vec4(4, 0, 0, 1)});
    const Pixels bare = studio.draw();
    studio.overlay.arrow_seconds = 0.2f;
    const std::vector<bool> mask = changed(bare, studio.draw());
    int leftmost = width;
    int rightmost = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (mask[static_cast<std::size_t>(y * width + x)]) {
                leftmost = std::min(leftmost, x);
                rightmost = std::max(rightmost, x);
                REQUIRE(std::abs(y - height / 2) < 10);
            }
        }
    }
    CHECK(static_cast<float>(leftmost) == Approx(160.0f - 0.3f * scale).margin(2.0));
    CHECK(static_cast<float>(rightmost) == Approx(160.0f + 0.5f * scale).margin(2.5));

    // Twice the time, twice the arrow; none without speed, without velocities, or where something is not finite.
    studio.overlay.arrow_seconds = 0.1f;
    CHECK(count(changed(bare, studio.draw())) < count(mask));
    studio.set_balls({vec4(-0.5f, 0, 0, 0.2f)}, {vec4(0, 0, 0, 1)});
    CHECK(studio.draw() == bare);
    studio.set_balls({vec4(-0.5f, 0, 0, 0.2f)}, {vec4(0.3f, 0, 0, 1)});  // two pixels say nothing
    CHECK(studio.draw() == bare);
    studio.set_balls({vec4(-0.5f, 0, 0, 0.2f)}, {vec4(not_a_number, 0, 0, 1)});
    CHECK(studio.draw() == bare);
    studio.set_balls({vec4(-0.5f, 0, 0, 0.2f)});
    CHECK(studio.draw() == bare);
    studio.set_balls({vec4(-0.5f, 0, 0, not_a_number)}, {vec4(4, 0, 0, 1)});
    const Pixels broken = studio.draw();
    studio.overlay.arrow_seconds = 0.0f;
    CHECK(studio.draw() == broken);
}

TEST_CASE_METHOD(GlFixture, "an arrow towards the eye is no mistake", "[view]") {
    Inside studio;
    studio.set_balls({vec4(0, 0, 0, 0.2f)}, {vec4(0, -4, 0, 1)});
    studio.overlay.arrow_seconds = 0.2f;
    const Pixels drawn = studio.draw();
    studio.overlay.arrow_seconds = 0.0f;
    const std::vector<bool> mask = changed(studio.draw(), drawn);
    const std::vector<bool> around = cast_rays(studio.picture.camera, vec4(0, 0, 0, 0.3f));
    for (std::size_t i = 0; i < mask.size(); ++i) {
        REQUIRE((!mask[i] || around[i]));
    }
}

TEST_CASE_METHOD(GlFixture, "balls are coloured by value as the legend says", "[view]") {
    Inside studio;
    studio.set_balls({vec4(0, 0, 0, 0.5f)}, {vec4(0, 0, 3, 1)});
    Model model = load_model(source("assets/models/ball.obj"));
    model.coarser.clear();
    model.parts[0].material.texture = {};
    model.parts[0].material.specular = vec3(0.0f);
    studio.renderer.set_model(model);
    const auto draw_value = [&](Palette palette, float value) {
        const gl::Buffer values = buffer_of(std::vector<float>{value});
        studio.picture.values = &values;
        studio.picture.ball_colour = BallColour::value;
        studio.picture.value_palette = palette;
        studio.picture.value_low = -2.0f;
        studio.picture.value_high = 6.0f;
        const vec3 pixel = studio.at(studio.draw(), vec3(0));
        studio.picture.values = nullptr;
        return linear_from_srgb(pixel / 255.0f);
    };
    const float infinity = std::numeric_limits<float>::infinity();
    for (const Look look : looks) {
        studio.picture.look = look;
        // Light times colour: what white gets tells the light.
        const vec3 middle = draw_value(Palette::diverging, 2.0f);
        const vec3 light = middle / linear_from_srgb(value_colour(Palette::diverging, 2.0f, -2.0f, 6.0f));
        for (const Palette palette : {Palette::sequential, Palette::diverging, Palette::categorical}) {
            for (const float value : {-infinity, -2.0f, 0.3f, 1.9f, 3.0f, 6.0f, 1e9f, infinity, not_a_number}) {
                const vec3 promised = linear_from_srgb(value_colour(palette, value, -2.0f, 6.0f));
                CAPTURE(static_cast<int>(palette), value);
                CHECK(near_to(draw_value(palette, value), light * promised, 0.012f));
            }
        }
        // Without values, as if nothing had been asked for.
        studio.picture.ball_colour = BallColour::value;
        const Pixels without = studio.draw();
        studio.picture.ball_colour = BallColour::tinted;
        CHECK(studio.draw() == without);
    }
}
