// What lies under the pointer, how the camera gets there, and what overlays and legends are made of.
#include "view/picking.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/random.h"
#include "support/catch.h"
#include "view/palette.h"

using namespace ballpit;
using namespace ballpit::view;

namespace {

constexpr float aspect = 16.0f / 9.0f;
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
const vec3 half{2.0f};
constexpr vec2 middle{0.5f, 0.5f};

float random_between(float low, float high, std::uint64_t stream, std::uint64_t index) {
    return low + (high - low) * static_cast<float>(random_unit(5, stream, index));
}

std::vector<vec4> random_balls(std::uint64_t count) {
    std::vector<vec4> balls;
    for (std::uint64_t i = 0; i < count; ++i) {
        balls.emplace_back(random_between(-2, 2, 0, i), random_between(-2, 2, 1, i), random_between(-2, 2, 2, i),
                           random_between(0.05f, 0.3f, 3, i));
    }
    return balls;
}

// Where a point appears, as a fraction of the picture from its upper left corner.
vec2 on_picture(const Camera& camera, const vec3& point) {
    const vec4 clip = projection(camera, half, aspect) * view_matrix(camera) * vec4(point, 1.0f);
    return {0.5f + 0.5f * clip.x / clip.w, 0.5f - 0.5f * clip.y / clip.w};
}

// m along the ray to where it enters the box; 0 from within.
std::optional<double> enters(const Ray& ray, const view::Box& box) {
    double first = 0.0;
    double last = 1e30;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (static_cast<double>(box.low[axis]) - ray.origin[axis]) / ray.direction[axis];
        const double b = (static_cast<double>(box.high[axis]) - ray.origin[axis]) / ray.direction[axis];
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
    return first <= last ? std::optional(first) : std::nullopt;
}

std::vector<CellRange> occupied(const Grid& grid, std::initializer_list<std::uint32_t> ids) {
    std::vector<CellRange> ranges(grid.cell_count(), CellRange{0, 0});
    for (const std::uint32_t id : ids) {
        ranges[id] = {3, 5};
    }
    return ranges;
}

}  // namespace

TEST_CASE("a ray goes through what appears at its point", "[view]") {
    const Camera camera = look(home(half, aspect), {0.1f, -0.05f});
    for (std::uint64_t i = 0; i < 50; ++i) {
        const vec3 point(random_balls(50)[i]);
        const Ray ray = ray_through(camera, aspect, on_picture(camera, point));
        CHECK(glm::length(ray.direction) == Approx(1.0f));
        CHECK(glm::length(glm::cross(point - ray.origin, ray.direction)) < 1e-4f);
    }
}

TEST_CASE("the ball picked is the first one along the ray, by marching", "[view]") {
    const Camera camera = home(half, aspect);
    const std::vector<vec4> balls = random_balls(150);
    int hits = 0;
    for (std::uint64_t i = 0; i < 300; ++i) {
        const vec2 point{random_between(0.2f, 0.8f, 7, i), random_between(0, 1, 8, i)};
        const Ray ray = ray_through(camera, aspect, point);
        std::optional<std::uint32_t> expected;
        float closest_call = 1.0f;  // m from a surface: nearer than a step of the march, nothing is certain
        for (float t = 0.0f; t < 20.0f && !expected; t += 0.002f) {
            for (std::uint32_t ball = 0; ball < balls.size() && !expected; ++ball) {
                const float outside = glm::distance(ray.origin + t * ray.direction, vec3(balls[ball])) - balls[ball].w;
                closest_call = outside > 0.0f ? std::min(closest_call, outside) : closest_call;
                if (outside <= 0.0f) {
                    expected = ball;
                }
            }
        }
        const auto picked = pick_ball(camera, half, aspect, point, balls);
        if (expected) {
            ++hits;
            CHECK(picked == expected);
        } else if (closest_call > 0.003f) {
            CHECK_FALSE(picked);
        }
    }
    CHECK(hits > 40);
}

TEST_CASE("balls that are not drawn are not picked", "[view]") {
    const Camera camera = home(half, aspect);
    const vec3 ahead = forward(camera);
    const float infinity = std::numeric_limits<float>::infinity();
    const std::vector<vec4> balls = {
        vec4(camera.position - ahead, 0.2f),             // behind the eye
        vec4(camera.position, 0.5f),                     // around it
        vec4(camera.position + 0.004f * ahead, 0.002f),  // before the near plane
        vec4(not_a_number, 0, 0, 1),
        vec4(0, 0, 0, infinity),
        vec4(0, 0, 0, not_a_number),
        vec4(ahead, 0.1f),
        vec4(0, 0, 0, 0.1f),
    };
    CHECK(pick_ball(camera, half, aspect, middle, balls) == 7u);
    CHECK_FALSE(pick_ball(camera, half, aspect, {0.02f, 0.02f}, balls));
    CHECK_FALSE(pick_ball(camera, half, aspect, middle, {}));
}

TEST_CASE("a slice that cuts away lets the pointer through to its layer", "[view]") {
    const Grid grid = make_grid(dvec3(half), 0.25, 1.0, 1);
    REQUIRE(grid.cells.z == 8);
    Camera camera;
    camera.pitch = -maximum_pitch;
    camera.position = -10.0f * forward(camera);
    const auto at_height = [&](float z) { return vec4(z / forward(camera).z * forward(camera), 0.1f); };
    const std::vector<vec4> balls = {at_height(1.7f), at_height(-1.6f), at_height(-1.2f), at_height(-1.05f)};
    CHECK(pick_ball(camera, half, aspect, middle, balls) == 0u);
    CHECK(pick_ball(camera, half, aspect, middle, balls, grid, {2, 1, true}) == 2u);  // the last one sticks out
    CHECK(pick_ball(camera, half, aspect, middle, balls, grid, {2, 1, false}) == 0u);
    CHECK(pick_ball(camera, half, aspect, middle, balls, grid, {2, 99, true}) == 0u);
    camera.pitch = maximum_pitch;
    camera.position = -10.0f * forward(camera);
    CHECK(pick_ball(camera, half, aspect, middle, balls, grid, {2, 1, true}) == 2u);
    CHECK(pick_ball(camera, half, aspect, middle, {&balls[0], 1}, grid, {2, 7, true}) == 0u);
}

TEST_CASE("the cell picked is the occupied one whose box the ray enters first", "[view]") {
    const Grid grid = make_grid(dvec3(half), 0.2, 1.0, 1);
    std::vector<CellRange> ranges(grid.cell_count(), CellRange{0, 0});
    for (std::uint32_t id = 0; id < grid.cell_count(); ++id) {
        ranges[id].end = random_unit(5, 11, id) < 0.04 ? 1 : 0;
    }
    Camera inside;
    inside.position = {0.1f, 0.2f, 0.3f};
    int hits = 0;
    for (const Camera& camera : {home(half, aspect), inside, look(inside, {1.3f, 0.4f})}) {
        for (std::uint64_t i = 0; i < 200; ++i) {
            const vec2 point{random_between(0, 1, 9, i), random_between(0, 1, 10, i)};
            const Ray ray = ray_through(camera, aspect, point);
            std::optional<double> expected;
            for (std::uint32_t id = 0; id < grid.cell_count(); ++id) {
                const std::optional<double> there = enters(ray, cell_box(grid, id));
                if (ranges[id].end != 0 && there && (!expected || *there < *expected)) {
                    expected = there;
                }
            }
            const auto picked = pick_cell(camera, aspect, point, grid, ranges);
            REQUIRE(picked.has_value() == expected.has_value());
            if (picked) {
                ++hits;
                const std::optional<double> there = enters(ray, cell_box(grid, *picked));
                CHECK(ranges[*picked].end != 0);
                CHECK(there.value_or(-1.0) == Approx(*expected).margin(1e-4));
            }
        }
    }
    CHECK(hits > 150);
}

TEST_CASE("a ray beside the grid, or along an axis, finds what it should", "[view]") {
    const Grid grid = make_grid(dvec3(half), 0.2, 1.0, 1);
    const std::uint32_t far_corner = grid.cell_count() - 1;
    Camera along_x;
    along_x.position = {-10.0f, 1.9f, 1.9f};
    CHECK(pick_cell(along_x, aspect, middle, grid, occupied(grid, {far_corner})) == far_corner);
    CHECK_FALSE(pick_cell(along_x, aspect, middle, grid, occupied(grid, {0})));
    along_x.position.x = 10.0f;
    CHECK_FALSE(pick_cell(along_x, aspect, middle, grid, occupied(grid, {far_corner})));
    along_x.position = {-10.0f, 1.9f, 9.0f};
    CHECK_FALSE(pick_cell(along_x, aspect, middle, grid, occupied(grid, {far_corner})));
}

TEST_CASE("a slice gives its own cells, occupied or not", "[view]") {
    const Grid grid = make_grid(dvec3(half), 0.25, 1.0, 1);
    const Camera camera = home(half, aspect);
    for (int axis = 0; axis < 3; ++axis) {
        for (std::uint32_t layer = 0; layer < grid.cells[axis]; ++layer) {
            const GridSlice slice{axis, layer};
            const auto plane = slice_plane(grid, slice, camera.position);
            REQUIRE(plane);
            uvec3 cell{2, 3, 1};
            cell[axis] = layer;
            const std::uint32_t id = (cell.z * grid.cells.y + cell.y) * grid.cells.x + cell.x;
            const view::Box box = cell_box(grid, id);
            vec3 face = 0.5f * (box.low + box.high);
            face[axis] = plane->normal[axis] * plane->place;
            CAPTURE(axis, layer);
            CHECK((face[axis] == Approx(box.low[axis]) || face[axis] == Approx(box.high[axis])));
            CHECK(glm::dot(camera.position - face, plane->normal) > 0.0f);  // the side that the eye sees
            CHECK(pick_cell(camera, aspect, on_picture(camera, face), grid, slice) == id);
        }
    }
    CHECK_FALSE(pick_cell(camera, aspect, {0.01f, 0.01f}, grid, GridSlice{2, 0}));
    CHECK_FALSE(pick_cell(camera, aspect, middle, grid, GridSlice{2, grid.cells.z}));
    CHECK_FALSE(pick_cell(camera, aspect, middle, grid, GridSlice{3, 0}));
    CHECK(pick_cell(Camera{}, aspect, middle, grid, GridSlice{0, 7}));
    CHECK_FALSE(pick_cell(Camera{}, aspect, middle, grid, GridSlice{0, 0}));  // behind the eye
}

TEST_CASE("flying to a ball puts it into the middle, a sixth of the picture high", "[view]") {
    const Camera camera = home(half, aspect);
    const vec3 target{0.7f, -1.2f, 0.4f};
    const float radius = 0.1f;
    const Camera there = fly_to(camera, target, radius);
    CHECK(there.yaw == camera.yaw);
    CHECK(there.pitch == camera.pitch);
    CHECK(glm::distance(on_picture(there, target), middle) < 1e-4f);
    const float high =
        on_picture(there, target - radius * up(there)).y - on_picture(there, target + radius * up(there)).y;
    CHECK(high == Approx(1.0f / 6.0f).epsilon(0.01));
    CHECK(pick_ball(there, half, aspect, middle, std::vector<vec4>{vec4(target, radius)}) == 0u);
}

TEST_CASE("a flight starts at one camera, ends at the other, and turns the short way", "[view]") {
    Camera a = home(half, aspect);
    a.yaw = 3.0f;
    Camera b = fly_to(a, vec3(1.0f), 0.1f);
    b.yaw = -3.0f;
    b.pitch = 0.3f;
    CHECK(blend(a, b, -1.0f).position == a.position);
    CHECK(blend(a, b, 2.0f).position == b.position);
    Camera before = a;
    for (int i = 1; i <= 20; ++i) {
        const Camera camera = blend(a, b, static_cast<float>(i) / 20.0f);
        CHECK(glm::distance(camera.position, b.position) < glm::distance(before.position, b.position));
        CHECK(std::abs(camera.yaw) >= 3.0f - 1e-5f);
        before = camera;
    }
    CHECK(glm::distance(blend(a, b, 0.5f).position, 0.5f * (a.position + b.position)) < 1e-5f);
    const float slow = glm::distance(blend(a, b, 0.05f).position, a.position);
    CHECK(slow < 0.2f * 0.05f * glm::distance(a.position, b.position));
}

TEST_CASE("a box has each of its twelve edges once", "[view]") {
    std::vector<LineSegment> lines;
    append_box(lines, {vec3(-1, -2, -3), vec3(1, 2, 3)}, vec4(1), 2.0f);
    REQUIRE(lines.size() == 12);
    std::set<std::pair<int, int>> edges;
    for (const LineSegment& line : lines) {
        const auto corner = [](const vec3& p) { return (p.x > 0 ? 1 : 0) + (p.y > 0 ? 2 : 0) + (p.z > 0 ? 4 : 0); };
        CHECK(glm::abs(line.from) == vec3(1, 2, 3));
        CHECK(glm::abs(line.to) == vec3(1, 2, 3));
        const int bits = corner(line.from) ^ corner(line.to);
        CHECK((bits == 1 || bits == 2 || bits == 4));
        edges.emplace(std::min(corner(line.from), corner(line.to)), bits);
    }
    CHECK(edges.size() == 12);
}

TEST_CASE("contacts are coloured by overlap, bows go from end to end", "[view]") {
    std::vector<LineSegment> lines;
    append_contact(lines, vec4(0, 0, 0, 1), vec4(1.9f, 0, 0, 1), 0.1f);
    append_contact(lines, vec4(0, 0, 0, 1), vec4(2.0f, 0, 0, 1), 0.1f);
    CHECK(glm::distance(vec3(lines[0].colour), sequential_palette.back()) < 1e-3f);
    CHECK(vec3(lines[1].colour) == sequential_palette.front());
    CHECK(lines[0].to == vec3(1.9f, 0, 0));
    lines.clear();
    append_arc(lines, vec3(0), vec3(4, 0, 0), 1.5f, vec4(1));
    CHECK(lines.front().from == vec3(0));
    CHECK(lines.back().to == vec3(4, 0, 0));
    float highest = 0.0f;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        CHECK(lines[i].from == lines[i - 1].to);
        highest = std::max(highest, lines[i].from.z);
    }
    CHECK(highest == Approx(1.5f));
}

TEST_CASE("a legend has round numbers at their places, and its unit once", "[view]") {
    for (const auto& [low, high] : {std::pair(0.0f, 8.0f), std::pair(0.0f, 1.0f), std::pair(-4.0f, 4.0f),
                                    std::pair(0.0013f, 0.0071f), std::pair(0.0f, 5000.0f), std::pair(3e-9f, 4e-8f),
                                    std::pair(0.0f, 1e12f), std::pair(-0.31f, 17.3f), std::pair(0.0f, 0.3f)}) {
        const ContinuousLegend legend = continuous_legend(Palette::sequential, low, high, "m/s");
        CAPTURE(low, high);
        CHECK(legend.colours.size() == sequential_palette.size());
        REQUIRE(legend.ticks.size() >= 2);
        CHECK(legend.ticks.size() <= 6);
        for (const LegendTick& tick : legend.ticks) {
            CAPTURE(tick.text);
            CHECK(std::stof(tick.text) == Approx(low + tick.place * (high - low)).margin(1e-3 * (high - low)));
            CHECK((tick.place >= 0.0f && tick.place <= 1.0f));
            CHECK(tick.text.size() < 16);
            CHECK((tick.text.find(" m/s") != std::string::npos) == (&tick == &legend.ticks.back()));
        }
    }
    CHECK(continuous_legend(Palette::sequential, 0.0f, 0.3f, "").ticks[1].text == "0.1");
    CHECK(continuous_legend(Palette::sequential, 0.0f, 5000.0f, "").ticks.back().text == "5000");
    CHECK(continuous_legend(Palette::diverging, 1.0f, 1.0f, "m").ticks.empty());
    CHECK(continuous_legend(Palette::diverging, 0.0f, not_a_number, "m").ticks.empty());
    const std::vector<std::string> names = {"one", "two"};
    CHECK(categorical_legend(names)[1].text == "two");
    CHECK(categorical_legend(names)[1].colour == categorical(1));
}

TEST_CASE("values get the colours that the legend promises", "[view]") {
    CHECK(value_colour(Palette::sequential, 2.0f, 2.0f, 6.0f) == sequential_palette.front());
    CHECK(value_colour(Palette::sequential, 9.0f, 2.0f, 6.0f) == sequential_palette.back());
    CHECK(value_colour(Palette::diverging, 4.0f, 2.0f, 6.0f) == diverging_palette[4]);
    CHECK(value_colour(Palette::categorical, 9.0f, 0.0f, 0.0f) == categorical_palette[1]);
    CHECK(value_colour(Palette::categorical, -1.0f, 0.0f, 0.0f) == no_value_colour);
    CHECK(value_colour(Palette::sequential, not_a_number, 0.0f, 1.0f) == no_value_colour);
    CHECK(value_colour(Palette::sequential, 1.0f, 1.0f, 1.0f) == sequential_palette.front());
}
