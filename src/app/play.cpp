#include "app/play.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/world.h"

namespace ballpit::app {

namespace {

BallSpec ball_at(const dvec3& place, const dvec3& velocity, const ui::PlayOptions& options) {
    return {place, velocity, options.radius, sphere_mass(options.radius, options.density), std::nullopt};
}

// Where the centre of such a ball may be.
view::Box inset(const view::Box& box, double radius) {
    return {box.low + vec3(static_cast<float>(radius)), box.high - vec3(static_cast<float>(radius))};
}

// m along the ray from `start` to the first place at which a ball of this radius touches no other.
double first_free(const view::Ray& ray, double start, double radius, std::span<const vec4> balls) {
    std::vector<std::pair<double, double>> taken;
    for (const vec4& ball : balls) {
        const dvec3 to_ball = dvec3(ball) - dvec3(ray.origin);
        const double along = glm::dot(to_ball, dvec3(ray.direction));
        const double reach = radius + static_cast<double>(ball.w);
        const double aside = reach * reach - (glm::dot(to_ball, to_ball) - along * along);
        if (aside > 0.0 && along + std::sqrt(aside) > start) {
            taken.emplace_back(along - std::sqrt(aside), along + std::sqrt(aside));
        }
    }
    std::ranges::sort(taken);
    const double clearance = 0.01 * radius;
    double place = start;
    for (const auto& [from, to] : taken) {
        if (from < place + clearance) {
            place = std::max(place, to + clearance);
        }
    }
    return place;
}

// Sites of a hexagonal close packing around the origin, nearest first, as far as `reach`; balls have radius 1/2.
std::vector<dvec3> close_packing(double reach) {
    const double row = std::sqrt(3.0) / 2.0;
    const double layer = std::sqrt(6.0) / 3.0;
    const int most = static_cast<int>(std::ceil(reach / layer)) + 1;
    std::vector<dvec3> sites;
    for (int k = -most; k <= most; ++k) {
        const int odd = std::abs(k % 2);
        for (int j = -most - 1; j <= most + 1; ++j) {
            for (int i = -most - 2; i <= most + 2; ++i) {
                const dvec3 site(i + 0.5 * std::abs((j + odd) % 2), row * (j + odd / 3.0), layer * k);
                if (glm::length(site) <= reach) {
                    sites.push_back(site);
                }
            }
        }
    }
    std::ranges::stable_sort(sites, {}, [](const dvec3& site) { return glm::dot(site, site); });
    return sites;
}

double clearance_at(const dvec3& place, std::span<const vec4> balls) {
    double clearance = std::numeric_limits<double>::infinity();
    for (const vec4& ball : balls) {
        clearance = std::min(clearance, glm::distance(place, dvec3(ball)) - static_cast<double>(ball.w));
    }
    return clearance;
}

// Pushed inside the walls by `reach`, or into the middle where the box is too narrow for that.
dvec3 pushed_inside(const dvec3& place, const view::Box& box, double reach) {
    const dvec3 middle = 0.5 * (dvec3(box.low) + dvec3(box.high));
    const dvec3 slack = glm::max(0.5 * (dvec3(box.high) - dvec3(box.low)) - reach, dvec3(0.0));
    return glm::clamp(place, middle - slack, middle + slack);
}

dvec3 cluster_centre(const view::Ray& ray, const view::RaySpan& way, const view::Box& box, double reach,
                     std::span<const vec4> balls) {
    constexpr int places = 17;  // odd: the middle is one of them
    dvec3 best{0.0};
    double freest = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < places; ++i) {
        const int from_middle = (i + 1) / 2 * (i % 2 == 1 ? -1 : 1);  // 0, -1, 1, -2, 2: nearer to the eye first
        const double share = 0.5 + static_cast<double>(from_middle) / (places - 1);
        const double along = std::lerp(static_cast<double>(way.enter), static_cast<double>(way.leave), share);
        const dvec3 place = pushed_inside(dvec3(ray.origin) + along * dvec3(ray.direction), box, reach);
        const double clearance = clearance_at(place, balls);
        if (clearance > freest) {
            freest = clearance;
            best = place;
        }
        if (clearance >= reach) {
            break;
        }
    }
    return best;
}

bool holds(const view::Box& box, const dvec3& place) {
    return glm::all(glm::greaterThanEqual(place, dvec3(box.low))) &&
           glm::all(glm::lessThanEqual(place, dvec3(box.high)));
}

}  // namespace

ui::PlayOptions usual_play(const Scene& scene) {
    ui::PlayOptions usual;
    const double smallest_side = 2.0 * std::min({scene.half_extent.x, scene.half_extent.y, scene.half_extent.z});
    usual.radius = 0.0;
    if (scene.fill) {
        usual.radius = scene.fill->radius[1];
        usual.density = scene.fill->density;
    }
    for (const BallSpec& ball : scene.balls) {
        if (ball.radius > usual.radius) {
            usual.radius = ball.radius;
            usual.density = ball.mass / sphere_mass(ball.radius, 1.0);
        }
    }
    if (usual.radius == 0.0) {  // no balls
        usual.radius = smallest_side / 50.0;
    }
    usual.speed = std::max({scene.half_extent.x, scene.half_extent.y, scene.half_extent.z});
    return usual;
}

std::optional<BallSpec> shot(const view::Ray& ray, const view::Box& box, const ui::PlayOptions& options,
                             std::span<const vec4> balls) {
    const auto way = view::span_in(ray, inset(box, options.radius));
    if (!way) {
        return std::nullopt;
    }
    const double along = first_free(ray, static_cast<double>(way->enter), options.radius, balls);
    if (along > static_cast<double>(way->leave)) {
        return std::nullopt;
    }
    const dvec3 direction = glm::normalize(dvec3(ray.direction));
    return ball_at(dvec3(ray.origin) + along * direction, options.speed * direction, options);
}

std::vector<BallSpec> cluster(const view::Ray& ray, const view::Box& box, const ui::PlayOptions& options,
                              std::span<const vec4> balls) {
    const auto way = view::span_in(ray, inset(box, options.radius));
    if (!way) {
        return {};
    }
    constexpr double packed = 0.74;  // of space, by such a packing
    constexpr double apart = 1.001;  // diameters: rounded to single, balls must not overlap
    const double diameter = 2.0 * apart * options.radius;
    const double reach = options.radius * (std::cbrt(options.cluster / packed) + 1.0);
    const dvec3 centre = cluster_centre(ray, *way, box, reach, balls);
    const double farthest = 2.0 * reach;
    std::vector<vec4> near;
    for (const vec4& ball : balls) {
        if (glm::distance(centre, dvec3(ball)) < farthest + static_cast<double>(ball.w) + diameter) {
            near.push_back(ball);
        }
    }
    const view::Box room = inset(box, options.radius);
    std::vector<BallSpec> cluster;
    for (const dvec3& site : close_packing(farthest / diameter)) {
        const dvec3 place = centre + diameter * site;
        if (cluster.size() < options.cluster && holds(room, place) && clearance_at(place, near) >= options.radius) {
            cluster.push_back(ball_at(place, dvec3(0.0), options));
        }
    }
    return cluster;
}

}  // namespace ballpit::app
