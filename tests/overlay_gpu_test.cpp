// What is drawn to look inside a step, pixel by pixel; and that nobody pays for what is not asked for.
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <utility>
#include <vector>

#include "core/layout.h"
#include "support/catch.h"
#include "support/gl_fixture.h"
#include "support/studio.h"

using namespace ballpit;
using namespace ballpit::test;

namespace {

constexpr vec4 red{1.0f, 0.0f, 0.0f, 1.0f};
constexpr float half_turn = 3.14159265f;

// Draw calls and uploads through glad's function pointers while this lives.
class CallCounter {
public:
    CallCounter() {
        calls = 0;
        arrays_ = glad_glDrawArrays;
        instanced_ = glad_glDrawArraysInstanced;
        elements_ = glad_glDrawElementsInstanced;
        upload_ = glad_glBufferSubData;
        glad_glDrawArrays = [](GLenum mode, GLint first, GLsizei n) {
            ++calls;
            arrays_(mode, first, n);
        };
        glad_glDrawArraysInstanced = [](GLenum mode, GLint first, GLsizei n, GLsizei instances) {
            ++calls;
            instanced_(mode, first, n, instances);
        };
        glad_glDrawElementsInstanced = [](GLenum mode, GLsizei n, GLenum type, const void* at, GLsizei instances) {
            ++calls;
            elements_(mode, n, type, at, instances);
        };
        glad_glBufferSubData = [](GLenum target, GLintptr offset, GLsizeiptr size, const void* bytes) {
            ++calls;
            upload_(target, offset, size, bytes);
        };
    }
    ~CallCounter() {
        glad_glDrawArrays = arrays_;
        glad_glDrawArraysInstanced = instanced_;
        glad_glDrawElementsInstanced = elements_;
        glad_glBufferSubData = upload_;
    }
    CallCounter(const CallCounter&) = delete;
    CallCounter& operator=(const CallCounter&) = delete;

    static inline int calls = 0;

private:
    static inline PFNGLDRAWARRAYSPROC arrays_ = nullptr;
    static inline PFNGLDRAWARRAYSINSTANCEDPROC instanced_ = nullptr;
    static inline PFNGLDRAWELEMENTSINSTANCEDPROC elements_ = nullptr;
    static inline PFNGLBUFFERSUBDATAPROC upload_ = nullptr;
};

// A studio with an overlay, seen from the front: x to the right, z up, no shadows; balls of two sizes fill the cells.
struct Inside : Studio {
    Overlay overlay;
    gl::Buffer ranges;

    Inside() {
        picture.overlay = &overlay;
        picture.camera = Camera{};
        picture.camera.position = {0, -5, 0};
        picture.camera.yaw = 0.5f * half_turn;
        picture.show_shadows = false;
        picture.grid = make_grid(dvec3(1.0), 0.25, 1.0, 1);
        REQUIRE(picture.grid.cells == uvec3(4));
    }

    // Balls a cell; what is not named is empty.
    void set_counts(std::initializer_list<std::pair<uvec3, std::uint32_t>> counts) {
        std::vector<CellRange> table(picture.grid.cell_count(), CellRange{0, 0});
        for (const auto& [cell, n] : counts) {
            table[(cell.z * 4 + cell.y) * 4 + cell.x] = {7, 7 + n};
        }
        ranges = buffer_of(table);
        picture.cell_ranges = &ranges;
    }

    vec3 at(const Pixels& pixels, const vec3& place) const { return pixel_at(pixels, picture, place); }
    float pixels_a_metre() const { return 0.5f * height / std::tan(0.5f * picture.camera.field_of_view) / 5.0f; }
};

bool near_to(const vec3& a, const vec3& b, float tolerance) {
    return glm::all(glm::lessThanEqual(glm::abs(a - b), vec3(tolerance)));
}

}  // namespace

TEST_CASE_METHOD(GlFixture, "an empty overlay costs no draw call, no upload and no pixel", "[view]") {
    Inside studio;
    studio.set_balls({vec4(0, 0, 0, 0.4f), vec4(0.5f, 0, 0, 0.2f)}, {vec4(0, 0, 1, 1), vec4(0, 0, 1, 1)});
    studio.set_counts({{{1, 1, 1}, 2}});
    studio.picture.show_box = studio.picture.show_ground = true;
    for (const Look look : looks) {
        studio.picture.look = look;
        studio.picture.overlay = nullptr;
        studio.draw();
        const CallCounter counter;
        const Pixels without = studio.draw();
        const int needed = std::exchange(CallCounter::calls, 0);
        REQUIRE(needed > 4);
        studio.picture.overlay = &studio.overlay;
        CHECK(studio.draw() == without);
        CHECK(CallCounter::calls == needed);
        CallCounter::calls = 0;
        studio.overlay.arrow_seconds = 0.1f;
        studio.draw();
        CHECK(CallCounter::calls == needed + 1);
        studio.overlay.arrow_seconds = 0.0f;
    }
}

TEST_CASE_METHOD(GlFixture, "a line has its place, its colour and its width", "[view]") {
    Inside studio;
    const Pixels bare = studio.draw();
    for (const float thickness : {2.0f, 6.0f, 12.0f}) {
        studio.overlay.lines = {{vec3(-0.8f, 0, -0.5f), vec3(0.8f, 0, 0.5f), red, thickness}};
        const Pixels drawn = studio.draw();
        const float scale = studio.pixels_a_metre();
        const vec2 along = glm::normalize(vec2(1.6f, 1.0f));
        const float half_length = 0.5f * scale * glm::length(vec2(1.6f, 1.0f));
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const vec2 from_middle{static_cast<float>(x) + 0.5f - 160.0f, 120.0f - static_cast<float>(y) - 0.5f};
                const float beyond = std::max(std::abs(glm::dot(from_middle, along)) - half_length, 0.0f);
                const float beside = from_middle.y * along.x - from_middle.x * along.y;
                const float away = glm::length(vec2(beyond, beside)) - 0.5f * thickness;
                const std::size_t i = index_of(x, y);
                const vec3 pixel{drawn[i], drawn[i + 1], drawn[i + 2]};
                if (away < -0.6f) {
                    REQUIRE(near_to(pixel, vec3(255, 0, 0), 2.0f));
                } else if (away > 1.6f) {
                    REQUIRE(std::equal(&drawn[i], &drawn[i] + 3, &bare[i]));
                } else if (away > 0.7f && away < 1.0f) {
                    REQUIRE(pixel.z < static_cast<float>(bare[i + 2]));  // the dark rim
                }
            }
        }
    }
}

TEST_CASE_METHOD(GlFixture, "a line behind a ball shows through as faintly as it says", "[view]") {
    Inside studio;
    studio.set_balls({vec4(0, 0, 0, 0.4f)});
    const vec3 ball = studio.at(studio.draw(), vec3(0));
    const LineSegment behind{vec3(-0.8f, 1, 0), vec3(0.8f, 1, 0), red, 8.0f, 0.25f};
    studio.overlay.lines = {behind};
    const Pixels drawn = studio.draw();
    CHECK(near_to(studio.at(drawn, vec3(0)), glm::mix(ball, vec3(255, 0, 0), 0.25f), 2.0f));
    CHECK(near_to(studio.at(drawn, vec3(0.6f, 1, 0)), vec3(255, 0, 0), 2.0f));
    studio.overlay.lines[0].hidden = 0.0f;
    CHECK(studio.at(studio.draw(), vec3(0)) == ball);
    // Inside the ball: hidden, unless it is lifted above its surface.
    studio.overlay.lines[0] = {vec3(-0.2f, 0, 0), vec3(0.2f, 0, 0), red, 8.0f, 0.0f};
    CHECK(studio.at(studio.draw(), vec3(0)) == ball);
    studio.overlay.lines[0].lift = 0.42f;
    CHECK(near_to(studio.at(studio.draw(), vec3(0)), vec3(255, 0, 0), 2.0f));
    studio.set_balls({vec4(0, 0, 0, 0.4f), vec4(0, -0.8f, 0, 0.3f)});
    CHECK_FALSE(near_to(studio.at(studio.draw(), vec3(0)), vec3(255, 0, 0), 60.0f));  // a ball in front still hides it
    studio.overlay.lines[0].lift = 100.0f;  // beyond the eye: no worse than at it
    CHECK(near_to(studio.at(studio.draw(), vec3(0)), vec3(255, 0, 0), 2.0f));
}

TEST_CASE_METHOD(GlFixture, "a line that passes the eye is cut, not smeared over the picture", "[view]") {
    Inside studio;
    const Pixels bare = studio.draw();
    studio.overlay.lines = {{vec3(0, 1, 0), vec3(0.3f, -9, -0.4f), red, 4.0f}};
    const auto covered = count(changed(bare, studio.draw()));
    CHECK(covered > 50);
    CHECK(covered < 3000);
    studio.overlay.lines = {{vec3(0, -8, 0), vec3(0.3f, -9, -0.4f), red, 4.0f}};
    CHECK(studio.draw() == bare);
    studio.overlay.lines = {{vec3(0), vec3(0), red, 8.0f}};  // a point is a dot
    CHECK(near_to(studio.at(studio.draw(), vec3(0)), vec3(255, 0, 0), 2.0f));
}

TEST_CASE_METHOD(GlFixture, "a highlight is a ring round its ball, also where other balls hide it", "[view]") {
    Inside studio;
    const vec4 ball{0.2f, 0.1f, 0.1f, 0.6f};
    for (const Look look : looks) {
        studio.picture.look = look;
        studio.set_balls({vec4(-0.8f, 0, 0, 0.2f), ball});
        studio.overlay.highlights.clear();
        const Pixels bare = studio.draw();
        studio.overlay.highlights = {{1, red}};
        const Pixels marked = studio.draw();
        const std::vector<bool> mask = changed(bare, marked);
        const auto rays = [&](float grown) {
            return cast_rays(studio.picture.camera, vec4(vec3(ball), grown * ball.w));
        };
        const std::vector<bool> reach = rays(1.35f);
        for (std::size_t i = 0; i < mask.size(); ++i) {
            REQUIRE((!mask[i] || reach[i]));
        }
        const vec3 on_ring = vec3(ball) + 1.06f * ball.w * vec3(1, 0, 0);
        CHECK(near_to(studio.at(marked, on_ring), vec3(255, 0, 0), 12.0f));
        // Behind a larger ball it shows through; the other ball of the same place does not.
        studio.overlay.highlights.clear();
        studio.set_balls({vec4(0, -1.2f, 0, 0.9f), vec4(0, 1, 0, 0.6f)});
        const Pixels hidden = studio.draw();
        studio.overlay.highlights = {{1, red}};
        const vec3 ring_behind{1.06f * 0.6f, 1, 0};
        const vec3 before = studio.at(hidden, ring_behind);
        const vec3 after = studio.at(studio.draw(), ring_behind);
        CHECK(near_to(after, glm::mix(before, vec3(255, 0, 0), 0.55f), 8.0f));
    }
}

TEST_CASE_METHOD(GlFixture, "highlights of balls that are not there, or not finite, draw nothing", "[view]") {
    Inside studio;
    studio.set_balls({vec4(0, 0, 0, 0.3f), vec4(not_a_number, 0, 0, 0.3f)});
    const Pixels bare = studio.draw();
    studio.overlay.highlights = {{1, red}, {2, red}, {0xFFFFFFFFu, red}};
    CHECK(studio.draw() == bare);
    studio.set_balls({});
    CHECK_NOTHROW(studio.draw());
}

TEST_CASE_METHOD(GlFixture, "blinking goes by the picture's time alone", "[view]") {
    Inside studio;
    studio.set_balls({vec4(0, 0, 0, 0.3f)});
    studio.overlay.highlights = {{0, red, 2.0f}};
    const Pixels bright = studio.draw();
    CHECK(studio.draw() == bright);
    studio.picture.time_s = 0.25f;
    const Pixels dim = studio.draw();
    const vec3 on_ring{0.32f, 0, 0};
    CHECK(studio.at(dim, on_ring).x < 0.6f * studio.at(bright, on_ring).x);
    studio.picture.time_s = 0.5f;
    CHECK(differences(changed(bright, studio.draw()), changed(bright, bright)) < 5);
    studio.overlay.highlights[0].blink_hz = 0.0f;
    const Pixels steady = studio.draw();
    studio.picture.time_s = 0.77f;
    CHECK(studio.draw() == steady);
}

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

TEST_CASE_METHOD(GlFixture, "two pictures stand side by side, and touch nothing outside", "[view]") {
    Inside studio;
    studio.picture.show_box = studio.picture.show_ground = studio.picture.show_light = true;
    studio.set_balls({vec4(0, 0, 0, 0.4f), vec4(-0.6f, 0, -0.2f, 0.3f)});
    studio.overlay.lines = {{vec3(-3, 0, 0), vec3(3, 0, 1), red, 9.0f}};  // beyond the picture's sides
    Picture& picture = studio.picture;
    picture.camera = home(picture.half_extent, 0.6f);
    picture.width = 150;
    picture.height = 200;
    const gl::Framebuffer small(150, 200);
    small.bind();
    studio.renderer.draw(picture);
    const Pixels alone = small.pixels();

    studio.framebuffer.bind();
    glClearColor(1.0f, 0.0f, 1.0f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    picture.x = 4;
    picture.y = 12;
    studio.renderer.draw(picture);
    picture.x = 166;
    studio.renderer.draw(picture);
    CHECK(glIsEnabled(GL_SCISSOR_TEST) == GL_FALSE);
    const Pixels both = studio.framebuffer.pixels();
    int outside = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t i = index_of(x, y);
            const int row = y - (height - 12 - 200);
            const int column = x < 160 ? x - 4 : x - 166;
            if (row < 0 || row >= 200 || column < 0 || column >= 150) {
                ++outside;
                REQUIRE((both[i] == 255 && both[i + 1] == 0 && both[i + 2] == 255));
                continue;
            }
            const auto j = 3 * static_cast<std::size_t>(row * 150 + column);
            for (std::size_t c = 0; c < 3; ++c) {
                REQUIRE(std::abs(both[i + c] - alone[j + c]) <= 2);  // the backdrop's noise goes by the framebuffer
            }
        }
    }
    CHECK(outside == width * height - 2 * 150 * 200);
}

TEST_CASE_METHOD(GlFixture, "an overlay leaves no state behind that others would trip over", "[view]") {
    Inside studio;
    studio.set_counts({{{1, 1, 1}, 2}});
    studio.set_balls({vec4(0, 0, 0, 0.3f), vec4(0.5f, 0, 0, 0.3f)}, {vec4(1), vec4(1)});
    for (const Look look : looks) {
        studio.picture.look = look;
        studio.picture.overlay = nullptr;
        const Pixels bare = studio.draw();
        studio.picture.overlay = &studio.overlay;
        studio.overlay = {{{vec3(0), vec3(1), red}}, {{0, red, 1.0f}}, 0.5f, 0.3f, GridSlice{2, 1}, 3};
        studio.draw();
        CHECK(glIsEnabled(GL_DEPTH_TEST) == GL_FALSE);
        CHECK(glIsEnabled(GL_BLEND) == GL_FALSE);
        CHECK(glIsEnabled(GL_CULL_FACE) == GL_FALSE);
        CHECK(glIsEnabled(GL_SCISSOR_TEST) == GL_FALSE);
        CHECK(glGetError() == GL_NO_ERROR);
        studio.picture.overlay = nullptr;
        CHECK(studio.draw() == bare);
    }
}
