#include "view/ball_mesh.h"

#include <array>
#include <cassert>
#include <span>
#include <string_view>

#include "view/ball_points.h"

namespace ballpit::view {

namespace {

template <class T>
gl::Buffer static_buffer(std::string_view label, std::span<const T> elements) {
    gl::Buffer buffer(label, elements.size_bytes(), GL_STATIC_DRAW);
    buffer.write(std::as_bytes(elements));
    return buffer;
}

gl::Texture make_texture(const Image& image) {
    constexpr std::array<unsigned char, 4> white = {255, 255, 255, 255};
    return image.pixels.empty() ? gl::Texture(1, 1, white) : gl::Texture(image.width, image.height, image.pixels);
}

}  // namespace

BallMesh::BallMesh(const Model& model)
    : vertices(static_buffer("ball model vertices", std::span(model.vertices))),
      indices(static_buffer("ball model indices", std::span(model.indices))),
      closed(model.closed) {
    assert(!model.parts.empty() && !model.indices.empty());
    array.floats(at_vertex, vertices, 3, sizeof(Vertex), offsetof(Vertex, position));
    array.floats(at_normal, vertices, 3, sizeof(Vertex), offsetof(Vertex, normal));
    array.floats(at_uv, vertices, 2, sizeof(Vertex), offsetof(Vertex, uv));
    array.indices(indices);
    for (const Part& part : model.parts) {
        const Material& material = part.material;
        surfaces.push_back({static_cast<GLsizei>(part.index_count), part.first_index, material.diffuse,
                            material.specular, material.shininess, make_texture(material.texture)});
    }
}

}  // namespace ballpit::view
