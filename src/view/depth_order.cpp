#include "view/depth_order.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace ballpit::view {

std::vector<std::uint32_t> nearest_first(std::span<const vec4> positions, const Camera& camera) {
    constexpr std::size_t bins = 1024;
    const vec3 ahead = forward(camera);
    std::vector<float> depths;
    depths.reserve(positions.size());
    float nearest = std::numeric_limits<float>::max();
    float farthest = std::numeric_limits<float>::lowest();
    for (const vec4& position : positions) {
        const float depth = glm::dot(vec3(position) - camera.position, ahead);
        depths.push_back(depth);
        nearest = std::min(nearest, depth);
        farthest = std::max(farthest, depth);
    }
    const float bins_a_metre = static_cast<float>(bins - 1) / std::max(farthest - nearest, 1e-6f);
    const auto bin_of = [&](float depth) {
        const float place = (depth - nearest) * bins_a_metre;
        return place >= 0.0f && place < static_cast<float>(bins) ? static_cast<std::size_t>(place) : bins - 1;
    };
    std::array<std::uint32_t, bins> places{};  // first how many balls a bin has, then where its next one goes
    for (const float depth : depths) {
        ++places[bin_of(depth)];
    }
    std::uint32_t end = 0;
    for (std::uint32_t& place : places) {
        place = std::exchange(end, end + place);
    }
    std::vector<std::uint32_t> order(positions.size());
    for (std::uint32_t ball = 0; ball < order.size(); ++ball) {
        order[places[bin_of(depths[ball])]++] = ball;
    }
    return order;
}

}  // namespace ballpit::view
