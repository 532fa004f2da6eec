// Lines and rings drawn to look inside a step, pixel by pixel; and that nobody pays for what is not asked for.
#include <algorithm>
#include <cmath>
#include <utility>

#include "support/catch.h"
#include "support/gl_fixture.h"
#include "support/studio.h"

using namespace ballpit;
using namespace ballpit::test;

namespace {

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
        CallCounter::calls = 0;
        studio.overlay.highlights = {{0, red}};  // an upload, what is seen, what shows through
        studio.draw();
        CHECK(CallCounter::calls == needed + 3);
        studio.overlay.highlights.clear();
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
                    REQUIRE(pixel.x < static_cast<float>(bare[i]));  // the dark rim
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

TEST_CASE_METHOD(GlFixture, "a tether leads from its ball to a point, wherever the ball is", "[view]") {
    Inside studio;
    studio.set_balls({vec4(0.5f, 0, 0, 0.1f), vec4(-0.5f, 0, 0, 0.1f)});
    const Pixels bare = studio.draw();
    studio.overlay.tether = Tether{1, vec3(-0.5f, 0, 0.8f), red};
    const vec3 halfway(-0.5f, 0, 0.4f);
    CHECK(near_to(studio.at(studio.draw(), halfway), vec3(255, 0, 0), 3.0f));
    studio.set_balls({vec4(0.5f, 0, 0, 0.1f), vec4(-0.5f, 0, 0.6f, 0.1f)});
    CHECK_FALSE(near_to(studio.at(studio.draw(), halfway), vec3(255, 0, 0), 3.0f));
    studio.set_balls({vec4(0.5f, 0, 0, 0.1f), vec4(-0.5f, 0, 0, 0.1f)});
    studio.overlay.tether->ball = 2;  // not there
    CHECK(studio.draw() == bare);
}

TEST_CASE_METHOD(GlFixture, "the outline of a face lies in it", "[view]") {
    std::vector<LineSegment> lines;
    const view::Box box{vec3(-1, -2, -3), vec3(1, 2, 3)};
    append_face(lines, box, 1, true, red);
    REQUIRE(lines.size() == 4);
    float length = 0.0f;
    for (const LineSegment& line : lines) {
        CHECK(line.from.y == 2.0f);
        CHECK(line.to.y == 2.0f);
        length += glm::distance(line.from, line.to);
    }
    CHECK(length == 2.0f * (2.0f + 6.0f));
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

TEST_CASE_METHOD(GlFixture, "an overlay leaves no state behind that others would trip over", "[view]") {
    Inside studio;
    studio.set_counts({{{1, 1, 1}, 2}});
    studio.set_balls({vec4(0, 0, 0, 0.3f), vec4(0.5f, 0, 0, 0.3f)}, {vec4(1), vec4(1)});
    for (const Look look : looks) {
        studio.picture.look = look;
        studio.picture.overlay = nullptr;
        const Pixels bare = studio.draw();
        studio.picture.overlay = &studio.overlay;
        studio.overlay = {{{vec3(0), vec3(1), red}}, {{0, red, 1.0f}}, 0.5f, 0.3f, GridSlice{2, 1}, 3,
                          Tether{0, vec3(0.5f), red}};
        studio.draw();
        CHECK(glIsEnabled(GL_DEPTH_TEST) == GL_FALSE);
        CHECK(glIsEnabled(GL_BLEND) == GL_FALSE);
        CHECK(glIsEnabled(GL_CULL_FACE) == GL_FALSE);
        CHECK(glIsEnabled(GL_SCISSOR_TEST) == GL_FALSE);
        GLint depth_func = 0;
        glGetIntegerv(GL_DEPTH_FUNC, &depth_func);
        CHECK(depth_func == GL_LEQUAL);
        CHECK(glGetError() == GL_NO_ERROR);
        studio.picture.overlay = nullptr;
        CHECK(studio.draw() == bare);
    }
}
