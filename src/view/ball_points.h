// Balls as points: the programs that draw a point a ball, and the buffers that feed them.
#pragma once

#include <filesystem>
#include <string>

#include "gl/program.h"
#include "gl/vertex_array.h"
#include "view/picture.h"

namespace ballpit::view {

/// Attribute locations of all ball shaders.
enum BallAttribute : GLuint { at_vertex, at_normal, at_uv, at_ball, at_velocity, at_presence, at_value, at_number };

/// Positions and velocities of the picture's balls; divisor 1: an instance a ball. The buffers change places every
/// substep, hence anew for each picture. Without velocities the positions stand in: no shader then looks at them.
void point_at_balls(gl::VertexArray& array, const Picture& picture, GLuint divisor);

class BallPoints {
public:
    /// Of the shaders <stem>.vert and <stem>.frag, for balls coloured as such or by value. Throws gl::ShaderError.
    BallPoints(const std::filesystem::path& shader_folder, const std::string& stem);

    /// The program in use afterwards.
    const gl::Program& use(const Picture& picture, bool valued);
    /// After that: every ball once, in this order, or, null, in that of the buffers.
    void draw(const Picture& picture, const gl::Buffer* order);

private:
    gl::Program usual_;
    gl::Program valued_;
    gl::VertexArray array_;
};

}  // namespace ballpit::view
