// What the renderer draws, pixel by pixel, against what geometry says; and that what is broken is skipped or refused.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/layout.h"
#include "gl/error.h"
#include "gl/framebuffer.h"
#include "support/catch.h"
#include "support/gl_fixture.h"
#include "view/frame.h"
#include "view/renderer.h"
#include "view/view_program.h"

using namespace ballpit;
using namespace ballpit::view;

namespace {

namespace fs = std::filesystem;
using Pixels = std::vector<unsigned char>;

constexpr int width = 320;
constexpr int height = 240;
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

fs::path source(const char* name) { return fs::path(BALLPIT_SOURCE_DIR) / name; }

template <class T>
gl::Buffer buffer_of(const std::vector<T>& elements) {
    gl::Buffer buffer("test", elements.size() * sizeof(T));
    buffer.write(std::as_bytes(std::span(elements)));
    return buffer;
}

// A renderer, a bare picture of a box of 2 m, and what became of it.
struct Scene {
    Renderer renderer{source("glsl"), load_model(source("assets/models/ball.obj"))};
    gl::Framebuffer framebuffer{width, height};
    gl::Buffer positions;
    gl::Buffer velocities;
    Picture picture;

    Scene() {
        picture.half_extent = vec3(1.0f);
        picture.grid = make_grid(dvec3(1.0), 0.25, 1.0, 1);
        picture.camera = home(picture.half_extent);
        picture.show_box = picture.show_ground = picture.show_light = false;
        picture.width = width;
        picture.height = height;
    }

    void set_balls(const std::vector<vec4>& balls, const std::vector<vec4>& speeds = {}) {
        positions = buffer_of(balls);
        velocities = buffer_of(speeds);
        picture.positions = &positions;
        picture.velocities = speeds.empty() ? nullptr : &velocities;
        picture.ball_count = static_cast<std::uint32_t>(balls.size());
    }

    Pixels draw() {
        framebuffer.bind();
        renderer.draw(picture);
        return framebuffer.pixels();
    }
};

std::size_t index_of(int x, int y) { return 3 * (static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)); }

std::vector<bool> changed(const Pixels& a, const Pixels& b) {
    std::vector<bool> mask;
    for (std::size_t i = 0; i < a.size(); i += 3) {
        mask.push_back(!std::equal(a.begin() + static_cast<std::ptrdiff_t>(i),
                                   a.begin() + static_cast<std::ptrdiff_t>(i) + 3,
                                   b.begin() + static_cast<std::ptrdiff_t>(i)));
    }
    return mask;
}

std::ptrdiff_t count(const std::vector<bool>& mask) { return std::count(mask.begin(), mask.end(), true); }

// Which pixels' rays meet the ball.
std::vector<bool> cast_rays(const Camera& camera, const vec4& ball) {
    std::vector<bool> mask;
    const float high = std::tan(0.5f * camera.field_of_view);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const float u = (2.0f * (static_cast<float>(x) + 0.5f) / width - 1.0f) * high * width / height;
            const float v = (1.0f - 2.0f * (static_cast<float>(y) + 0.5f) / height) * high;
            const vec3 ray = glm::normalize(forward(camera) + u * right(camera) + v * up(camera));
            const vec3 to_ball = vec3(ball) - camera.position;
            const float along = glm::dot(to_ball, ray);
            mask.push_back(along > 0.0f && glm::length(to_ball - along * ray) < ball.w);
        }
    }
    return mask;
}

std::ptrdiff_t differences(const std::vector<bool>& a, const std::vector<bool>& b) {
    std::ptrdiff_t n = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        n += a[i] != b[i] ? 1 : 0;
    }
    return n;
}

vec3 pixel_at(const Pixels& pixels, const Picture& picture, const vec3& place) {
    const mat4 matrix = projection(picture.camera, picture.half_extent, static_cast<float>(width) / height) *
                        view_matrix(picture.camera);
    const vec4 clip = matrix * vec4(place, 1.0f);
    const int x = static_cast<int>((0.5f + 0.5f * clip.x / clip.w) * width);
    const int y = static_cast<int>((0.5f - 0.5f * clip.y / clip.w) * height);
    const std::size_t i = index_of(x, y);
    return {pixels[i], pixels[i + 1], pixels[i + 2]};
}

// From the side of a direction, level with the box's centre.
Camera look_at_from_side(Camera camera, const vec3& direction) {
    camera.yaw = std::atan2(direction.y, direction.x) + 1.5707963f;
    camera.pitch = 0.0f;
    camera.position = -5.0f * forward(camera);
    return camera;
}

constexpr std::array looks = {Look::model, Look::impostor};

}  // namespace

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
    CHECK(offset_of("frame.sequential[0]") == offsetof(F, sequential));
    CHECK(offset_of("frame.categorical[0]") == offsetof(F, categorical));
    GLint size = 0;
    glGetActiveUniformBlockiv(program.id(), glGetUniformBlockIndex(program.id(), "Frame"), GL_UNIFORM_BLOCK_DATA_SIZE,
                              &size);
    CHECK(static_cast<std::size_t>(size) == sizeof(F));
}

TEST_CASE_METHOD(test::GlFixture, "an impostor covers exactly the pixels whose rays meet the ball", "[view]") {
    Scene scene;
    scene.picture.look = Look::impostor;
    const Pixels empty = scene.draw();
    // In the middle, at the picture's edge where perspective draws an ellipse, and cut by it.
    const Camera camera = scene.picture.camera;
    for (const vec4& ball : {vec4(0, 0, 0, 0.9f), vec4(2.0f * right(camera), 0.4f), vec4(1.5f * up(camera), 0.3f),
                             vec4(camera.position + forward(camera) + 0.4f * right(camera), 0.7f)}) {
        CAPTURE(ball.x, ball.y, ball.z, ball.w);
        scene.set_balls({ball});
        const std::vector<bool> expected = cast_rays(camera, ball);
        REQUIRE(count(expected) > 100);
        CHECK(differences(changed(empty, scene.draw()), expected) <= 4);
    }
}

TEST_CASE_METHOD(test::GlFixture, "the model covers the same pixels, but for its corners", "[view]") {
    Scene scene;
    const Pixels empty = scene.draw();
    const vec4 ball{0.2f, 0.1f, -0.3f, 0.6f};
    scene.set_balls({ball});
    const std::vector<bool> expected = cast_rays(scene.picture.camera, ball);
    scene.picture.grid.cell_width = 1.2;  // a ball of this size is drawn with the fine mesh
    CHECK(differences(changed(empty, scene.draw()), expected) < count(expected) / 40);
    scene.picture.grid.cell_width = 0.1;
    CHECK(differences(changed(empty, scene.draw()), expected) < count(expected) / 10);
}

TEST_CASE_METHOD(test::GlFixture, "the nearer ball hides the farther one, in either order", "[view]") {
    Scene scene;
    scene.picture.ball_colour = BallColour::speed;
    scene.picture.top_speed = 1.0f;
    const vec3 towards_eye = -forward(scene.picture.camera);
    const vec4 near_ball{0.5f * towards_eye, 0.3f};
    const vec4 far_ball{-0.5f * towards_eye, 0.5f};
    for (const Look look : looks) {
        scene.picture.look = look;
        scene.set_balls({near_ball, far_ball}, {vec4(0, 0, 1, 1), vec4(0)});
        const vec3 fast = pixel_at(scene.draw(), scene.picture, vec3(0.0f));
        CHECK(fast.x > fast.z);  // yellow
        scene.set_balls({far_ball, near_ball}, {vec4(0, 0, 1, 1), vec4(0)});
        const vec3 slow = pixel_at(scene.draw(), scene.picture, vec3(0.0f));
        CHECK(slow.z > slow.x);  // blue
    }
}

TEST_CASE_METHOD(test::GlFixture, "a ball that is not finite, or around the eye, does not spoil the picture",
                 "[view]") {
    Scene scene;
    scene.picture.show_ground = true;
    const float infinity = std::numeric_limits<float>::infinity();
    const vec3 eye = scene.picture.camera.position;
    for (const Look look : looks) {
        scene.picture.look = look;
        scene.set_balls({vec4(0, 0, 0, 0.3f)});
        const Pixels good = scene.draw();
        scene.set_balls({vec4(0, 0, 0, 0.3f), vec4(not_a_number, 0, 0, 0.3f), vec4(0, 0, infinity, 0.3f),
                         vec4(0, 0, 0, not_a_number), vec4(0.5f, 0, 0, infinity), vec4(eye, 0.2f)});
        CHECK(scene.draw() == good);
    }
}

TEST_CASE_METHOD(test::GlFixture, "no balls, no size: nothing to draw is no mistake", "[view]") {
    Scene scene;
    const Pixels empty = scene.draw();
    scene.set_balls({});
    CHECK(scene.draw() == empty);
    scene.picture.width = 0;
    CHECK(scene.draw() == empty);  // a minimised window: what was there stays
}

TEST_CASE_METHOD(test::GlFixture, "buffers that change places are followed", "[view]") {
    Scene scene;
    const gl::Buffer first = buffer_of(std::vector<vec4>{vec4(-0.5f, 0, 0, 0.2f)});
    const gl::Buffer second = buffer_of(std::vector<vec4>{vec4(0.5f, 0, 0, 0.2f)});
    scene.picture.ball_count = 1;
    for (const Look look : looks) {
        scene.picture.look = look;
        scene.picture.positions = &first;
        const Pixels before = scene.draw();
        scene.picture.positions = &second;
        CHECK(scene.draw() != before);
        scene.picture.positions = &first;
        CHECK(scene.draw() == before);
    }
}

TEST_CASE_METHOD(test::GlFixture, "each part of the surroundings shows when asked for", "[view]") {
    Scene scene;
    const Pixels bare = scene.draw();
    for (bool Picture::*part : {&Picture::show_box, &Picture::show_ground, &Picture::show_light}) {
        scene.picture.*part = true;
        CHECK(count(changed(bare, scene.draw())) > 20);
        scene.picture.*part = false;
    }
    scene.picture.show_ground = true;
    scene.picture.camera.position.z = -3.0f;
    const Pixels from_below = scene.draw();
    scene.picture.show_ground = false;
    CHECK(scene.draw() == from_below);  // the ground would hide the balls
}

TEST_CASE_METHOD(test::GlFixture, "occupied cells are drawn where they are, empty ones not at all", "[view]") {
    Scene scene;
    const Pixels bare = scene.draw();
    scene.picture.grid = make_grid(dvec3(1.0), 0.25, 1.0, 1);
    REQUIRE(scene.picture.grid.cells == uvec3(4));
    std::vector<CellRange> ranges(64, CellRange{0, 0});
    gl::Buffer empty = buffer_of(ranges);
    scene.picture.cell_ranges = &empty;
    scene.picture.show_cells = true;
    CHECK(scene.draw() == bare);
    ranges[(2 * 4 + 3) * 4 + 1] = {5, 13};  // cell (1, 3, 2)
    const gl::Buffer one = buffer_of(ranges);
    scene.picture.cell_ranges = &one;
    const std::vector<bool> mask = changed(bare, scene.draw());
    const vec3 middle{-0.25f, 0.75f, 0.25f};
    const std::vector<bool> within = cast_rays(scene.picture.camera, vec4(middle, 0.24f * std::sqrt(3.0f)));
    const std::vector<bool> core = cast_rays(scene.picture.camera, vec4(middle, 0.22f));
    for (std::size_t i = 0; i < mask.size(); ++i) {
        REQUIRE((!mask[i] || within[i]));
        REQUIRE((mask[i] || !core[i]));
    }
}

TEST_CASE_METHOD(test::GlFixture, "material and texture of the model show", "[view]") {
    Scene scene;
    scene.picture.ball_colour = BallColour::plain;
    scene.set_balls({vec4(0, 0, 0, 0.8f)});
    Model model = load_model(source("assets/models/ball.obj"));
    model.coarser.clear();
    Material& material = model.parts[0].material;
    material.specular = vec3(0.0f);
    for (const Look look : looks) {
        scene.picture.look = look;
        material.texture = {1, 1, {255, 0, 0, 255}};
        material.diffuse = vec3(1.0f);
        scene.renderer.set_model(model);
        const vec3 red = pixel_at(scene.draw(), scene.picture, vec3(0.0f));
        CHECK((red.x > 50.0f && red.y == 0.0f && red.z == 0.0f));
        material.texture = {};
        material.diffuse = vec3(0.0f, 0.0f, 1.0f);
        scene.renderer.set_model(model);
        const vec3 blue = pixel_at(scene.draw(), scene.picture, vec3(0.0f));
        CHECK((blue.z > 50.0f && blue.x == 0.0f && blue.y == 0.0f));
    }
}

TEST_CASE_METHOD(test::GlFixture, "a ball shades what lies behind it, and never itself", "[view]") {
    Scene scene;
    scene.picture.grid.cell_width = 0.8;
    const vec3 to_light = glm::normalize(position(scene.picture.light, scene.picture.half_extent));
    const vec4 ball{0, 0, 0, 0.4f};
    const vec4 above{0.85f * to_light, 0.4f};
    const vec3 top = 0.4f * to_light;
    for (const Look look : looks) {
        scene.picture.look = look;
        scene.picture.show_shadows = true;
        scene.set_balls({ball});
        const Pixels alone = scene.draw();
        scene.picture.show_shadows = false;
        CHECK(scene.draw() == alone);
        scene.picture.camera = look_at_from_side(scene.picture.camera, to_light);
        scene.set_balls({ball, above});
        const vec3 lit = pixel_at(scene.draw(), scene.picture, 0.97f * top);
        scene.picture.show_shadows = true;
        const vec3 shaded = pixel_at(scene.draw(), scene.picture, 0.97f * top);
        CHECK(shaded.x < 0.9f * lit.x);
        scene.picture.camera = home(scene.picture.half_extent);
    }
}

TEST_CASE_METHOD(test::GlFixture, "drawing leaves no state behind that others would trip over", "[view]") {
    Scene scene;
    scene.picture.show_box = scene.picture.show_ground = scene.picture.show_light = true;
    scene.set_balls({vec4(0, 0, 0, 0.3f)});
    scene.draw();
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
