// Everything around the balls: backdrop, ground, the box's edges and the light's marker. No buffers: the shaders
// make their few vertices from their numbers.
#pragma once

#include <filesystem>

#include "gl/program.h"
#include "gl/vertex_array.h"

namespace ballpit::view {

class Surroundings {
public:
    explicit Surroundings(const std::filesystem::path& shader_folder);

    /// `simple`: at least cost, for a CPU that draws.
    void draw_background(bool simple) const;
    void draw_ground(bool simple) const;
    void draw_box() const;
    void draw_light_marker() const;

private:
    gl::Program background_;
    gl::Program simple_background_;
    gl::Program ground_;
    gl::Program simple_ground_;
    gl::Program box_;
    gl::Program light_marker_;
    gl::VertexArray no_attributes_;
};

}  // namespace ballpit::view
