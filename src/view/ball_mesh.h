// The ball's model on the device.
#pragma once

#include <cstddef>
#include <vector>

#include "gl/buffer.h"
#include "gl/texture.h"
#include "gl/vertex_array.h"
#include "view/model.h"

namespace ballpit::view {

struct BallSurface {
    GLsizei index_count = 0;
    std::size_t first_index = 0;
    vec3 diffuse{0.0f};
    vec3 specular{0.0f};
    float shininess = 1.0f;
    gl::Texture texture;
};

struct BallMesh {
    explicit BallMesh(const Model& model);

    gl::VertexArray array;
    gl::Buffer vertices;
    gl::Buffer indices;
    std::vector<BallSurface> surfaces;
    bool closed = false;
};

}  // namespace ballpit::view
