// Balls for a CPU that draws: a point each, worked out as far as possible once a ball instead of once a pixel.
#pragma once

#include <filesystem>

#include "view/ball_points.h"

namespace ballpit::view {

class SimpleBalls {
public:
    explicit SimpleBalls(const std::filesystem::path& shader_folder);

    /// Whether the picture asks for this look, and no ball in it is larger than a point can be.
    bool can_draw(const Picture& picture) const;
    /// The program in use afterwards, for the surface's uniforms.
    const gl::Program& use(const Picture& picture, bool valued);
    /// After that, with the depth test on.
    void draw(const Picture& picture);

private:
    BallPoints points_;
    float largest_point_ = 1.0f;  // pixels
};

}  // namespace ballpit::view
