#include "view/picking.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace ballpit::view {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// m along the ray to where it enters the ball; not positive behind the eye or around it, NaN for a miss. By the
// distance of the centre from the ray: no difference of large squares.
float entry(const Ray& ray, const vec4& ball) {
    const vec3 to_centre = vec3(ball) - ray.origin;
    const float along = glm::dot(to_centre, ray.direction);
    const vec3 miss = to_centre - along * ray.direction;
    return along - std::sqrt(ball.w * ball.w - glm::dot(miss, miss));
}

template <class Skip>
std::optional<std::uint32_t> nearest_ball(const Camera& camera, const vec3& half_extent, const Ray& ray,
                                          std::span<const vec4> positions, const Skip& skip) {
    std::optional<std::uint32_t> nearest;
    const float nearest_drawn = depth_range(camera, half_extent).x / glm::dot(ray.direction, forward(camera));
    float distance = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const float hit = entry(ray, positions[i]);
        // Never true for NaN, hence for no miss and no ball that is not finite.
        if (hit >= nearest_drawn && hit < distance && !skip(positions[i])) {
            distance = hit;
            nearest = static_cast<std::uint32_t>(i);
        }
    }
    return nearest;
}

// The cells along a ray, from the first one in the grid to the last.
class CellWalk {
public:
    CellWalk(const Grid& grid, const Ray& ray) : cells_(grid.cells) {
        const dvec3 start = (dvec3(ray.origin) - grid.origin) / grid.cell_width;
        const dvec3 direction(ray.direction);
        double enter = 0.0;
        double leave = infinity;
        for (int axis = 0; axis < 3; ++axis) {
            const double low = (0.0 - start[axis]) / direction[axis];
            const double high = (cells_[axis] - start[axis]) / direction[axis];
            const bool beside = direction[axis] == 0.0 && (start[axis] < 0.0 || start[axis] >= cells_[axis]);
            enter = direction[axis] == 0.0 ? enter : std::max(enter, std::min(low, high));
            leave = beside ? -1.0 : direction[axis] == 0.0 ? leave : std::min(leave, std::max(low, high));
        }
        inside_ = enter <= leave;
        for (int axis = 0; inside_ && axis < 3; ++axis) {
            const double last = cells_[axis] - 1.0;
            cell_[axis] = static_cast<int>(std::clamp(std::floor(start[axis] + enter * direction[axis]), 0.0, last));
            step_[axis] = direction[axis] < 0.0 ? -1 : 1;
            const double face = cell_[axis] + (direction[axis] < 0.0 ? 0.0 : 1.0);
            next_[axis] = direction[axis] == 0.0 ? infinity : (face - start[axis]) / direction[axis];
            a_cell_[axis] = direction[axis] == 0.0 ? infinity : std::abs(1.0 / direction[axis]);
        }
    }

    bool inside() const { return inside_; }

    std::uint32_t id() const {
        const uvec3 cell(cell_);
        return (cell.z * cells_.y + cell.y) * cells_.x + cell.x;
    }

    void advance() {
        const int axis = next_.x < next_.y ? (next_.x < next_.z ? 0 : 2) : (next_.y < next_.z ? 1 : 2);
        cell_[axis] += step_[axis];
        next_[axis] += a_cell_[axis];
        inside_ = cell_[axis] >= 0 && cell_[axis] < static_cast<int>(cells_[axis]);
    }

private:
    uvec3 cells_;
    bool inside_ = false;
    glm::ivec3 cell_{0};
    glm::ivec3 step_{1};
    dvec3 next_{0.0};    // along the ray, to the next face across each axis
    dvec3 a_cell_{0.0};  // from one face to the next
};

}  // namespace

Ray ray_through(const Camera& camera, float aspect, const vec2& point) {
    const float high = std::tan(0.5f * camera.field_of_view);
    const vec3 across = (2.0f * point.x - 1.0f) * high * aspect * right(camera);
    return {camera.position, glm::normalize(forward(camera) + across + (1.0f - 2.0f * point.y) * high * up(camera))};
}

std::optional<std::uint32_t> pick_ball(const Camera& camera, const vec3& half_extent, float aspect, const vec2& point,
                                       std::span<const vec4> positions) {
    const Ray ray = ray_through(camera, aspect, point);
    return nearest_ball(camera, half_extent, ray, positions, [](const vec4&) { return false; });
}

std::optional<std::uint32_t> pick_ball(const Camera& camera, const vec3& half_extent, float aspect, const vec2& point,
                                       std::span<const vec4> positions, const Grid& grid, const GridSlice& slice) {
    const Ray ray = ray_through(camera, aspect, point);
    const std::optional<SlicePlane> plane = slice_plane(grid, slice, camera.position);
    return nearest_ball(camera, half_extent, ray, positions,
                        [&](const vec4& ball) { return plane && is_cut_away(slice, *plane, ball); });
}

std::optional<std::uint32_t> pick_cell(const Camera& camera, float aspect, const vec2& point, const Grid& grid,
                                       std::span<const CellRange> ranges) {
    assert(ranges.size() >= grid.cell_count());
    for (CellWalk walk(grid, ray_through(camera, aspect, point)); walk.inside(); walk.advance()) {
        const CellRange& range = ranges[walk.id()];
        if (range.first != range.end) {
            return walk.id();
        }
    }
    return std::nullopt;
}

std::optional<std::uint32_t> pick_cell(const Camera& camera, float aspect, const vec2& point, const Grid& grid,
                                       const GridSlice& slice) {
    const Ray ray = ray_through(camera, aspect, point);
    const std::optional<SlicePlane> plane = slice_plane(grid, slice, camera.position);
    const float towards = plane ? glm::dot(plane->normal, ray.direction) : 0.0f;
    if (towards == 0.0f) {
        return std::nullopt;
    }
    const float distance = (plane->place - glm::dot(plane->normal, ray.origin)) / towards;
    const dvec3 hit = (dvec3(ray.origin + distance * ray.direction) - grid.origin) / grid.cell_width;
    uvec3 cell(0u);
    for (int axis = 0; axis < 3; ++axis) {
        const bool outside = !(hit[axis] >= 0.0 && hit[axis] < grid.cells[axis]);
        if (distance <= 0.0f || (axis != slice.axis && outside)) {
            return std::nullopt;
        }
        cell[axis] = axis == slice.axis ? slice.layer : static_cast<std::uint32_t>(hit[axis]);
    }
    return (cell.z * grid.cells.y + cell.y) * grid.cells.x + cell.x;
}

Camera fly_to(const Camera& camera, const vec3& target, float radius) {
    constexpr float pictures_a_ball = 6.0f;
    Camera there = camera;
    const float distance = pictures_a_ball * radius / std::tan(0.5f * camera.field_of_view);
    there.position = target - distance * forward(camera);
    return there;
}

Camera blend(const Camera& a, const Camera& b, float t) {
    if (t <= 0.0f) {
        return a;
    }
    if (t >= 1.0f) {
        return b;
    }
    constexpr float full_turn = 2.0f * std::numbers::pi_v<float>;
    const float share = t * t * (3.0f - 2.0f * t);
    Camera camera;
    camera.position = glm::mix(a.position, b.position, share);
    camera.yaw = std::remainder(a.yaw + share * std::remainder(b.yaw - a.yaw, full_turn), full_turn);
    camera.pitch = glm::mix(a.pitch, b.pitch, share);
    camera.field_of_view = glm::mix(a.field_of_view, b.field_of_view, share);
    return camera;
}

}  // namespace ballpit::view
