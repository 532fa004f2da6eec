#include "view/hidden_balls.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ballpit::view {

namespace {

constexpr float doubt = 0.1f;  // pixels: where a ball ends is known no better than the driver rounds

// A disc in the picture; pixels from its lower left corner.
struct Disc {
    float x, y, radius;
};

// One bit a pixel: whether a ball is drawn there already.
class CoveredPixels {
public:
    CoveredPixels(int width, int height)
        : width_(width), height_(height), words_(static_cast<std::size_t>(width + 63) / 64) {
        bits_.resize(words_ * static_cast<std::size_t>(height));
    }

    /// Whether all pixels of the picture whose middle lies in the disc are covered; also where there are none.
    bool covers(const Disc& disc) const {
        return each_word(disc, [this](std::size_t word, std::uint64_t mask) { return (bits_[word] & mask) == mask; });
    }

    void cover(const Disc& disc) {
        each_word(disc, [this](std::size_t word, std::uint64_t mask) {
            bits_[word] |= mask;
            return true;
        });
    }

private:
    // The first whole number `from` or above, within the picture.
    static int clipped(float from, int size) {
        return static_cast<int>(std::ceil(std::clamp(from, 0.0f, static_cast<float>(size))));
    }

    // Ends with `act`'s first no, and tells whether there was none.
    template <class Act>
    bool each_word(const Disc& disc, const Act& act) const {
        const int top = clipped(disc.y + disc.radius - 0.5f, height_);
        for (int row = clipped(disc.y - disc.radius - 0.5f, height_); row < top; ++row) {
            const float above = static_cast<float>(row) + 0.5f - disc.y;
            const float half = std::sqrt(std::max(disc.radius * disc.radius - above * above, 0.0f));
            const auto first = static_cast<unsigned>(clipped(disc.x - half - 0.5f, width_));
            const auto end = static_cast<unsigned>(clipped(disc.x + half - 0.5f, width_));
            const std::size_t line = words_ * static_cast<std::size_t>(row);
            for (unsigned from = first; from < end; from = (from / 64 + 1) * 64) {
                const unsigned bits = std::min(end - from, 64 - from % 64);
                const std::uint64_t ones = ~std::uint64_t{0} >> (64 - bits);
                if (!act(line + from / 64, ones << (from % 64))) {
                    return false;
                }
            }
        }
        return true;
    }

    int width_;
    int height_;
    std::size_t words_;  // of a row
    std::vector<std::uint64_t> bits_;
};

}  // namespace

std::vector<std::uint32_t> without_hidden(std::span<const std::uint32_t> order, std::span<const vec4> positions,
                                          const Picture& picture) {
    const Camera& camera = picture.camera;
    const vec3 ahead = forward(camera);
    const vec3 aside = right(camera);
    const vec3 upwards = up(camera);
    const vec2 planes = depth_range(camera, picture.half_extent);
    const auto width = static_cast<float>(picture.width);
    const auto height = static_cast<float>(picture.height);
    const float pixels_per_radian = 0.5f * height / std::tan(0.5f * camera.field_of_view);
    CoveredPixels covered(picture.width, picture.height);
    std::vector<std::uint32_t> seen;
    seen.reserve(order.size());
    for (const std::uint32_t ball : order) {
        const vec3 away = vec3(positions[ball]) - camera.position;
        const float radius = std::abs(positions[ball].w);
        const float depth = glm::dot(away, ahead);
        const float squared = glm::dot(away, away);
        if (!(depth > radius) || !std::isfinite(squared)) {
            continue;  // behind the eye, or nowhere
        }
        const float right_of = glm::dot(away, aside);
        const float above = glm::dot(away, upwards);
        const float scale = pixels_per_radian / depth;
        // A flat disc within the ball is surely drawn; what perspective pulls out on the side away from the picture's
        // middle (see ball_simple.vert) is all that there can be.
        Disc disc{0.5f * width + scale * right_of, 0.5f * height + scale * above, 0.0f};
        const float aslant = std::sqrt(right_of * right_of + above * above);
        const float cosine = (depth * std::sqrt(squared - radius * radius) - aslant * radius) / squared;
        constexpr float least_cosine = 0.1f;
        disc.radius = scale * radius / cosine + 0.5f + doubt;
        if (cosine > least_cosine && covered.covers(disc)) {
            continue;
        }
        seen.push_back(ball);
        disc.radius = scale * radius - doubt;
        if (disc.radius > 0.0f && depth > planes.x && depth < planes.y) {
            covered.cover(disc);
        }
    }
    return seen;
}

}  // namespace ballpit::view
