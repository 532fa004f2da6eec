#include "core/world.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "core/random.h"

namespace ballpit {

namespace {

constexpr std::uint32_t tries_per_ball = 64;
enum Stream : std::uint64_t { stream_radius, stream_direction, stream_position };

// Balls placed so far, found again by cell: intrusive lists over cells as wide as the largest diameter.
class PlacedBalls {
public:
    PlacedBalls(const dvec3& lower, const dvec3& upper, double width, std::uint32_t balls)
        : lower_(lower), width_(width), next_(balls, none) {
        // A sparse region gets wider cells: the table need not have more cells than there are balls.
        const dvec3 size = upper - lower;
        while ((size.x / width_ + 1) * (size.y / width_ + 1) * (size.z / width_ + 1) > 4.0 * balls + 64.0) {
            width_ *= 1.25;
        }
        for (int axis = 0; axis < 3; ++axis) {
            cells_[axis] = static_cast<int>(size[axis] / width_) + 1;
        }
        first_.assign(static_cast<std::size_t>(cells_.x) * static_cast<std::size_t>(cells_.y) *
                          static_cast<std::size_t>(cells_.z),
                      none);
    }

    bool is_free(const std::vector<vec4>& positions, const vec4& candidate) const {
        const glm::ivec3 middle = cell_of(candidate);
        const glm::ivec3 low = glm::max(middle - 1, glm::ivec3(0));
        const glm::ivec3 high = glm::min(middle + 1, cells_ - 1);
        for (int z = low.z; z <= high.z; ++z) {
            for (int y = low.y; y <= high.y; ++y) {
                for (int x = low.x; x <= high.x; ++x) {
                    for (std::uint32_t b = first_[index(x, y, z)]; b != none; b = next_[b]) {
                        const double distance = glm::distance(dvec3(positions[b]), dvec3(candidate));
                        if (distance < static_cast<double>(positions[b].w) + static_cast<double>(candidate.w)) {
                            return false;
                        }
                    }
                }
            }
        }
        return true;
    }

    void add(const vec4& position, std::uint32_t ball) {
        const glm::ivec3 cell = cell_of(position);
        std::uint32_t& first = first_[index(cell.x, cell.y, cell.z)];
        next_[ball] = first;
        first = ball;
    }

private:
    static constexpr std::uint32_t none = 0xFFFFFFFFu;

    glm::ivec3 cell_of(const vec4& position) const {
        const dvec3 cell = glm::clamp((dvec3(position) - lower_) / width_, dvec3(0.0), dvec3(cells_ - 1));
        return glm::ivec3(cell);
    }
    std::size_t index(int x, int y, int z) const {
        return (static_cast<std::size_t>(z) * static_cast<std::size_t>(cells_.y) + static_cast<std::size_t>(y)) *
                   static_cast<std::size_t>(cells_.x) +
               static_cast<std::size_t>(x);
    }

    dvec3 lower_;
    double width_;
    glm::ivec3 cells_{1};
    std::vector<std::uint32_t> first_;
    std::vector<std::uint32_t> next_;
};

// Uniform on the sphere (Archimedes: z is uniform).
dvec3 random_direction(std::uint64_t seed, std::uint64_t ball) {
    const double z = 2.0 * random_unit(seed, stream_direction, 2 * ball) - 1.0;
    const double angle = 2.0 * std::numbers::pi * random_unit(seed, stream_direction, 2 * ball + 1);
    const double ring = std::sqrt(1.0 - z * z);
    return {ring * std::cos(angle), ring * std::sin(angle), z};
}

BallSpec fill_ball(const Fill& fill, const dvec3& lower, const dvec3& upper, const PlacedBalls& placed,
                   const BallState& balls, std::uint64_t seed, std::uint32_t& overlapping) {
    const std::uint64_t ball = balls.count();
    BallSpec spec;
    spec.radius = std::lerp(fill.radius[0], fill.radius[1], random_unit(seed, stream_radius, ball));
    spec.mass = sphere_mass(spec.radius, fill.density);
    if (fill.speed > 0.0) {  // 0 times a negative direction would be -0, which compilers treat as they like
        spec.velocity = fill.speed * random_direction(seed, ball);
    }
    for (std::uint32_t attempt = 0; attempt < tries_per_ball; ++attempt) {
        const std::uint64_t index = (ball * tries_per_ball + attempt) * 3;
        for (int axis = 0; axis < 3; ++axis) {
            // The ball fits as a whole; where the region is narrower than the ball, it sits in the middle.
            const double slack = std::max(0.0, upper[axis] - lower[axis] - 2.0 * spec.radius);
            const double middle = 0.5 * (lower[axis] + upper[axis]);
            const double unit = random_unit(seed, stream_position, index + static_cast<std::uint64_t>(axis));
            spec.position[axis] = middle + slack * (unit - 0.5);
        }
        if (placed.is_free(balls.positions, vec4(vec3(spec.position), static_cast<float>(spec.radius)))) {
            return spec;
        }
    }
    ++overlapping;
    return spec;
}

}  // namespace

void add_ball(BallState& balls, const BallSpec& spec) {
    const auto radius = static_cast<float>(spec.radius);
    balls.positions.emplace_back(vec3(spec.position), spec.quarantined ? -radius : radius);
    balls.velocities.emplace_back(vec3(spec.velocity), static_cast<float>(spec.mass));
    const vec3 left(spec.position - dvec3(vec3(spec.position)));
    const vec3 left_velocity(spec.velocity - dvec3(vec3(spec.velocity)));
    balls.compensations.push_back(spec.compensation.value_or(
        Compensation{left.x, left.y, left.z, left_velocity.x, left_velocity.y, left_velocity.z}));
}

Variety variety_of(const BallState& balls) {
    Variety variety;
    variety.restitutions = !balls.restitutions.empty();
    if (balls.count() == 0) {
        return variety;
    }
    variety.mass = balls.velocities[0].w;
    variety.radius = std::abs(balls.positions[0].w);
    variety.radii =
        std::ranges::any_of(balls.positions, [&](const vec4& p) { return std::abs(p.w) != variety.radius; });
    variety.masses = std::ranges::any_of(balls.velocities, [&](const vec4& v) { return v.w != variety.mass; });
    variety.largest_radius = largest_radius(balls);
    variety.lightest_mass = variety.heaviest_mass = static_cast<double>(variety.mass);
    for (const vec4& velocity : balls.velocities) {
        const auto mass = static_cast<double>(velocity.w);
        variety.lightest_mass = std::min(variety.lightest_mass, mass);
        variety.heaviest_mass = std::max(variety.heaviest_mass, mass);
        variety.total_mass += mass;
    }
    return variety;
}

double sphere_mass(double radius, double density) {
    return density * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
}

double largest_radius(const BallState& balls) {
    float largest = 0.0f;
    for (const vec4& position : balls.positions) {
        largest = std::max(largest, std::abs(position.w));  // negative: in quarantine
    }
    return static_cast<double>(largest);
}

std::vector<double> ball_restitutions(const Scene& scene, const Settings& settings, std::uint32_t count) {
    const bool own = std::ranges::any_of(scene.balls, [](const BallSpec& b) { return b.restitution.has_value(); });
    if (!own && !settings.laws.ball_restitution) {
        return {};
    }
    const double others = settings.laws.restitution ? settings.restitution : 1.0;
    std::vector<double> restitutions(count, others);
    for (std::size_t i = 0; i < std::min<std::size_t>(count, scene.balls.size()); ++i) {
        restitutions[i] = scene.balls[i].restitution.value_or(others);
    }
    return restitutions;
}

World make_world(const Scene& scene, std::uint32_t count, std::uint64_t seed) {
    const auto listed = static_cast<std::uint32_t>(scene.balls.size());
    if (count > listed && !scene.fill) {
        throw InputError("setting 'balls' cannot be " + std::to_string(count) + ": scene '" + scene.name + "' lists " +
                         std::to_string(listed) + " and has no fill");
    }
    const double wide = widening(scene, count);
    const dvec3 scale{wide, wide, 1.0};
    World world;
    world.box = Box(scene.half_extent * scale);
    world.balls.restitutions = ball_restitutions(scene, scene.settings, count);
    world.balls.positions.reserve(count);
    world.balls.velocities.reserve(count);
    for (std::uint32_t i = 0; i < std::min(count, listed); ++i) {
        add_ball(world.balls, scene.balls[i]);
    }
    if (count <= listed) {
        return world;
    }
    const dvec3 lower = scene.fill->region[0] * scale;
    const dvec3 upper = scene.fill->region[1] * scale;
    double largest_radius = scene.fill->radius[1];
    for (const BallSpec& spec : scene.balls) {
        largest_radius = std::max(largest_radius, spec.radius);
    }
    PlacedBalls placed(lower, upper, 2.0 * largest_radius, count);
    for (std::uint32_t i = 0; i < count; ++i) {
        if (i >= listed) {
            add_ball(world.balls, fill_ball(*scene.fill, lower, upper, placed, world.balls, seed, world.overlapping));
        }
        placed.add(world.balls.positions[i], i);
    }
    return world;
}

}  // namespace ballpit
