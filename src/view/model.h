// What a ball looks like, as plain data: an OBJ file with its MTL materials and textures.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/vector.h"

namespace ballpit::view {

struct Vertex {
    vec3 position;
    vec3 normal;   // unit length
    glm::vec2 uv;  // v counts from the image's top row, as textures are stored
};

/// 8-bit RGBA, top row first.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<unsigned char> pixels;
};

struct Material {
    std::string name;
    vec3 diffuse{0.8f};  // linear
    vec3 specular{0.2f};
    float shininess = 32.0f;  // Blinn-Phong exponent
    Image texture;            // empty: none
};

/// Triangles [first_index, first_index + index_count) of one material.
struct Part {
    std::uint32_t first_index = 0;
    std::uint32_t index_count = 0;
    Material material;
};

/// Scaled and moved so that its bounding sphere is the unit sphere: instances scale it by the ball's radius.
struct Model {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<Part> parts;
    bool closed = false;         // a body seen from outside only: its back faces need not be drawn
    std::vector<Model> coarser;  // none, or one with fewer triangles, for balls that are small in the picture
};

/// Triangulates, computes missing normals. <stem>_coarse.obj beside it, if there is one, becomes the coarser model.
/// Throws InputError with file and reason: no such file, not an OBJ, no triangles, an index or number out of range, a
/// material file or texture that is named but missing or broken.
Model load_model(const std::filesystem::path& path);

}  // namespace ballpit::view
