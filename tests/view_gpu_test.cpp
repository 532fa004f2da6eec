// What the renderer draws, pixel by pixel, against what geometry says; and that what is broken is skipped or refused.
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>

#include "core/layout.h"
#include "gl/error.h"
#include "support/catch.h"
#include "support/gl_fixture.h"
#include "support/studio.h"
#include "view/frame.h"
#include "view/view_program.h"

using namespace ballpit;
using namespace ballpit::test;

namespace {

// From the side of a direction, level with the box's centre.
Camera look_at_from_side(Camera camera, const vec3& direction) {
    camera.yaw = std::atan2(direction.y, direction.x) + 1.5707963f;
    camera.pitch = 0.0f;
    camera.position = -5.0f * forward(camera);
    return camera;
}

}  // namespace

TEST_CASE_METHOD(test::GlFixture, "each pass of a picture is told of once, in order", "[view]") {
    Studio studio;
    studio.picture.show_box = true;
    studio.set_balls({vec4(0.0f, 0.0f, 0.0f, 0.5f)});
    std::vector<Pass> passes;
    std::vector<Pixels> after;
    studio.framebuffer.bind();
    studio.renderer.draw(studio.picture, [&](Pass pass) {
        passes.push_back(pass);
        after.push_back(studio.framebuffer.pixels());
    });
    CHECK(passes == std::vector{Pass::visibility, Pass::shadows, Pass::surroundings, Pass::balls, Pass::overlay});
    CHECK(passes.size() == pass_count);
    CHECK(after[2] != after[3]);
    CHECK(after[3] != after[4]);
    CHECK(after[4] == studio.draw());
}

TEST_CASE_METHOD(test::GlFixture, "the frame block lies in memory as the driver expects it", "[view]") {
    const gl::Program program = load_view_program(source("glsl"), "ball");
    const auto offset_of = [&](const char* member) {
        GLuint index = GL_INVALID_INDEX;
        glGetUniformIndices(program.id(), 1, &member, &index);
        GLint offset = -1;
        if (index != GL_INVALID_INDEX) {
            glGetActiveUniformsiv(program.id(), 1, &index, GL_UNIFORM_OFFSET, &offset);
        }
        return offset;
    };
    using F = view::layout::FrameParams;
    CHECK(offset_of("frame.view_projection") == offsetof(F, view_projection));
    CHECK(offset_of("frame.eye") == offsetof(F, eye));
    CHECK(offset_of("frame.pixels_per_radian") == offsetof(F, pixels_per_radian));
    CHECK(offset_of("frame.light_distance") == offsetof(F, light_distance));
    CHECK(offset_of("frame.grid_cells") == offsetof(F, grid_cells));
    CHECK(offset_of("frame.ball_colour") == offsetof(F, ball_colour));
    CHECK(offset_of("frame.picture_size") == offsetof(F, picture_size));
    CHECK(offset_of("frame.value_high") == offsetof(F, value_high));
    CHECK(offset_of("frame.value_palette") == offsetof(F, value_palette));
    CHECK(offset_of("frame.slice_place") == offsetof(F, slice_place));
    CHECK(offset_of("frame.arrow_seconds") == offsetof(F, arrow_seconds));
    CHECK(offset_of("frame.sequential[0]") == offsetof(F, sequential));
    CHECK(offset_of("frame.diverging[0]") == offsetof(F, diverging));
    CHECK(offset_of("frame.categorical[0]") == offsetof(F, categorical));
    GLint size = 0;
    glGetActiveUniformBlockiv(program.id(), glGetUniformBlockIndex(program.id(), "Frame"), GL_UNIFORM_BLOCK_DATA_SIZE,
                              &size);
    CHECK(static_cast<std::size_t>(size) == sizeof(F));
}

TEST_CASE_METHOD(test::GlFixture, "a ball found by ray covers exactly the pixels whose rays meet it", "[view]") {
    Studio studio;
    const Camera camera = studio.picture.camera;
    // In the middle, at the picture's edge where perspective draws an ellipse, and cut by it.
    const std::vector<vec4> balls = {vec4(0, 0, 0, 0.9f), vec4(2.0f * right(camera), 0.4f),
                                     vec4(1.5f * up(camera), 0.3f)};
    const vec4 close(camera.position + forward(camera) + 0.4f * right(camera), 0.7f);
    const auto expect_rays = [&](const Pixels& empty, const vec4& ball) {
        CAPTURE(studio.picture.look, ball.x, ball.y, ball.z, ball.w);
        studio.set_balls({ball});
        const std::vector<bool> expected = cast_rays(camera, ball);
        REQUIRE(count(expected) > 100);
        CHECK(differences(changed(empty, studio.draw()), expected) <= 4);
    };
    for (const Look look : {Look::impostor, Look::simple}) {
        studio.picture.look = look;
        studio.set_balls({});
        const Pixels empty = studio.draw();
        for (const vec4& ball : balls) {
            expect_rays(empty, ball);
        }
        if (look == Look::impostor) {
            expect_rays(empty, close);
        }
    }
}

TEST_CASE_METHOD(test::GlFixture, "the model covers the same pixels, but for its corners", "[view]") {
    Studio studio;
    const Pixels empty = studio.draw();
    const vec4 ball{0.2f, 0.1f, -0.3f, 0.6f};
    studio.set_balls({ball});
    const std::vector<bool> expected = cast_rays(studio.picture.camera, ball);
    studio.picture.grid.cell_width = 1.2;  // a ball of this size is drawn with the fine mesh
    CHECK(differences(changed(empty, studio.draw()), expected) < count(expected) / 40);
    studio.picture.grid.cell_width = 0.1;
    CHECK(differences(changed(empty, studio.draw()), expected) < count(expected) / 10);
}

TEST_CASE_METHOD(test::GlFixture, "the nearer ball hides the farther one, in either order", "[view]") {
    Studio studio;
    studio.picture.ball_colour = BallColour::speed;
    studio.picture.top_speed = 1.0f;
    const vec3 towards_eye = -forward(studio.picture.camera);
    const vec4 near_ball{0.5f * towards_eye, 0.3f};
    const vec4 far_ball{-0.5f * towards_eye, 0.5f};
    for (const Look look : {Look::model, Look::impostor, Look::simple}) {
        studio.picture.look = look;
        studio.set_balls({near_ball, far_ball}, {vec4(0, 0, 1, 1), vec4(0)});
        const vec3 fast = pixel_at(studio.draw(), studio.picture, vec3(0.0f));
        CHECK(fast.x > fast.z);  // yellow
        studio.set_balls({far_ball, near_ball}, {vec4(0, 0, 1, 1), vec4(0)});
        const vec3 slow = pixel_at(studio.draw(), studio.picture, vec3(0.0f));
        CHECK(slow.z > slow.x);  // blue
    }
}

TEST_CASE_METHOD(test::GlFixture, "a ball that is not finite, or around the eye, does not spoil the picture",
                 "[view]") {
    Studio studio;
    studio.picture.show_ground = true;
    const float infinity = std::numeric_limits<float>::infinity();
    const vec3 eye = studio.picture.camera.position;
    for (const Look look : looks) {
        studio.picture.look = look;
        studio.set_balls({vec4(0, 0, 0, 0.3f)});
        const Pixels good = studio.draw();
        studio.set_balls({vec4(0, 0, 0, 0.3f), vec4(not_a_number, 0, 0, 0.3f), vec4(0, 0, infinity, 0.3f),
                          vec4(0, 0, 0, not_a_number), vec4(0.5f, 0, 0, infinity), vec4(eye, 0.2f)});
        CHECK(studio.draw() == good);
    }
}

TEST_CASE_METHOD(test::GlFixture, "no balls, no size: nothing to draw is no mistake", "[view]") {
    Studio studio;
    const Pixels empty = studio.draw();
    studio.set_balls({});
    CHECK(studio.draw() == empty);
    studio.picture.width = 0;
    CHECK(studio.draw() == empty);  // a minimised window: what was there stays
}

TEST_CASE_METHOD(test::GlFixture, "buffers that change places are followed", "[view]") {
    Studio studio;
    const gl::Buffer first = buffer_of(std::vector<vec4>{vec4(-0.5f, 0, 0, 0.2f)});
    const gl::Buffer second = buffer_of(std::vector<vec4>{vec4(0.5f, 0, 0, 0.2f)});
    studio.picture.ball_count = 1;
    for (const Look look : looks) {
        studio.picture.look = look;
        studio.picture.positions = &first;
        const Pixels before = studio.draw();
        studio.picture.positions = &second;
        CHECK(studio.draw() != before);
        studio.picture.positions = &first;
        CHECK(studio.draw() == before);
    }
}

TEST_CASE_METHOD(test::GlFixture, "each part of the surroundings shows when asked for", "[view]") {
    Studio studio;
    const Pixels bare = studio.draw();
    for (bool Picture::*part : {&Picture::show_box, &Picture::show_ground, &Picture::show_light}) {
        studio.picture.*part = true;
        CHECK(count(changed(bare, studio.draw())) > 20);
        studio.picture.*part = false;
    }
    studio.picture.show_ground = true;
    studio.picture.camera.position.z = -3.0f;
    const Pixels from_below = studio.draw();
    studio.picture.show_ground = false;
    CHECK(studio.draw() == from_below);  // the ground would hide the balls
}

TEST_CASE_METHOD(test::GlFixture, "box and ground are drawn where the walls stand", "[view]") {
    Studio studio;
    Picture& picture = studio.picture;
    const Pixels bare = studio.draw();
    picture.box = {vec3(-0.8f, -0.5f, -0.6f), vec3(0.3f, 0.9f, 0.7f)};
    picture.show_box = true;
    const Pixels edges = studio.draw();
    for (int i = 0; i < 8; ++i) {  // by a step along the edge: lines end at the corners
        const vec3 side((i & 1) != 0 ? 1.0f : 0.0f, (i & 2) != 0 ? 1.0f : 0.0f, (i & 4) != 0 ? 0.9f : 0.1f);
        const vec3 place = glm::mix(picture.box.low, picture.box.high, side);
        CAPTURE(i);
        CHECK(pixel_at(edges, picture, place) != pixel_at(bare, picture, place));
    }
    CHECK(pixel_at(edges, picture, vec3(-1, -1, 0)) == pixel_at(bare, picture, vec3(-1, -1, 0)));
    picture.show_box = false;
    picture.show_ground = true;
    const Pixels ground = studio.draw();
    picture.box.low.z = -0.2f;
    CHECK(count(changed(ground, studio.draw())) > 100);  // the floor has come up
}

TEST_CASE_METHOD(test::GlFixture, "occupied cells are drawn where they are, empty ones not at all", "[view]") {
    Studio studio;
    const Pixels bare = studio.draw();
    studio.picture.grid = make_grid(dvec3(1.0), 0.25, 1.0, 1);
    REQUIRE(studio.picture.grid.cells == uvec3(4));
    std::vector<CellRange> ranges(64, CellRange{0, 0});
    gl::Buffer empty = buffer_of(ranges);
    studio.picture.cell_ranges = &empty;
    studio.picture.show_cells = true;
    CHECK(studio.draw() == bare);
    ranges[(2 * 4 + 3) * 4 + 1] = {5, 13};  // cell (1, 3, 2)
    const gl::Buffer one = buffer_of(ranges);
    studio.picture.cell_ranges = &one;
    const std::vector<bool> mask = changed(bare, studio.draw());
    const vec3 middle{-0.25f, 0.75f, 0.25f};
    const std::vector<bool> within = cast_rays(studio.picture.camera, vec4(middle, 0.24f * std::sqrt(3.0f)));
    const std::vector<bool> core = cast_rays(studio.picture.camera, vec4(middle, 0.22f));
    for (std::size_t i = 0; i < mask.size(); ++i) {
        REQUIRE((!mask[i] || within[i]));
        REQUIRE((mask[i] || !core[i]));
    }
}

TEST_CASE_METHOD(test::GlFixture, "material and texture of the model show", "[view]") {
    Studio studio;
    studio.picture.ball_colour = BallColour::plain;
    studio.set_balls({vec4(0, 0, 0, 0.8f)});
    Model model = load_model(source("assets/models/ball.obj"));
    model.coarser.clear();
    Material& material = model.parts[0].material;
    material.specular = vec3(0.0f);
    for (const Look look : looks) {
        studio.picture.look = look;
        material.texture = {1, 1, {255, 0, 0, 255}};
        material.diffuse = vec3(1.0f);
        studio.renderer.set_model(model);
        const vec3 textured = pixel_at(studio.draw(), studio.picture, vec3(0.0f));
        CHECK((textured.x > 50.0f && textured.y == 0.0f && textured.z == 0.0f));
        material.texture = {};
        material.diffuse = vec3(0.0f, 0.0f, 1.0f);
        studio.renderer.set_model(model);
        const vec3 blue = pixel_at(studio.draw(), studio.picture, vec3(0.0f));
        CHECK((blue.z > 50.0f && blue.x == 0.0f && blue.y == 0.0f));
    }
}

TEST_CASE_METHOD(test::GlFixture, "a ball shades what lies behind it, and never itself", "[view]") {
    Studio studio;
    studio.picture.grid.cell_width = 0.8;
    const vec3 to_light = glm::normalize(position(studio.picture.light, studio.picture.half_extent));
    const vec4 ball{0, 0, 0, 0.4f};
    const vec4 above{0.85f * to_light, 0.4f};
    const vec3 top = 0.4f * to_light;
    for (const Look look : looks) {
        studio.picture.look = look;
        studio.picture.show_shadows = true;
        studio.set_balls({ball});
        const Pixels alone = studio.draw();
        studio.picture.show_shadows = false;
        CHECK(studio.draw() == alone);
        studio.picture.camera = look_at_from_side(studio.picture.camera, to_light);
        studio.set_balls({ball, above});
        const vec3 lit = pixel_at(studio.draw(), studio.picture, 0.97f * top);
        studio.picture.show_shadows = true;
        const vec3 shaded = pixel_at(studio.draw(), studio.picture, 0.97f * top);
        CHECK(shaded.x < 0.9f * lit.x);
        studio.picture.camera = home(studio.picture.half_extent);
    }
}

TEST_CASE_METHOD(test::GlFixture, "drawing leaves no state behind that others would trip over", "[view]") {
    Studio studio;
    studio.picture.show_box = studio.picture.show_ground = studio.picture.show_light = true;
    studio.set_balls({vec4(0, 0, 0, 0.3f)});
    studio.draw();
    CHECK(glIsEnabled(GL_DEPTH_TEST) == GL_FALSE);
    CHECK(glIsEnabled(GL_BLEND) == GL_FALSE);
    CHECK(glIsEnabled(GL_CULL_FACE) == GL_FALSE);
    CHECK(glGetError() == GL_NO_ERROR);
}

TEST_CASE_METHOD(test::GlFixture, "a missing shader file is named", "[view]") {
    const Model model = load_model(source("assets/models/ball.obj"));
    std::string message;
    try {
        const Renderer renderer(source("docs"), model);
    } catch (const gl::ShaderError& error) {
        message = error.what();
    }
    CHECK(message.find("ball.vert") != std::string::npos);
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
    glClearDepth(0.25);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glClearDepth(1.0);
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
    float depth = 0.0f;
    glReadPixels(160, 100, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    CHECK(depth == Approx(0.25f).margin(1e-4));
}
