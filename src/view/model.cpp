#include "view/model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "core/error.h"
#include "view/image.h"
#include "view/obj_file.h"
#include "view/palette.h"

namespace ballpit::view {

namespace fs = std::filesystem;

namespace {

// OpenGL 3.3 hardware has at least this.
constexpr int largest_texture = 8192;

// One vertex for each different (position, normal, texture coordinate) that a corner names.
class Builder {
public:
    Builder(const fs::path& path, const ObjFile& file) : path_(path), file_(file) {
        measure();
        sum_face_normals();
    }

    Model build() {
        std::map<int, std::vector<std::uint32_t>> indices_of_material;
        for (const tinyobj::shape_t& shape : file_.shapes) {
            for (std::size_t corner = 0; corner < shape.mesh.indices.size(); ++corner) {
                const int material = shape.mesh.material_ids[corner / 3];
                indices_of_material[material].push_back(vertex(shape.mesh.indices[corner]));
            }
        }
        for (const auto& [material, indices] : indices_of_material) {
            model_.parts.push_back({static_cast<std::uint32_t>(model_.indices.size()),
                                    static_cast<std::uint32_t>(indices.size()), make_material(material)});
            model_.indices.insert(model_.indices.end(), indices.begin(), indices.end());
        }
        model_.closed = is_closed();
        return std::move(model_);
    }

private:
    // Every edge is passed once in each direction, and the faces look outwards.
    bool is_closed() const {
        std::map<std::pair<int, int>, int> passes;
        double volume = 0.0;
        for_each_triangle([&](int a, int b, int c) {
            for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
                ++passes[{from, to}];
            }
            volume += glm::dot(placed(a), glm::cross(placed(b), placed(c)));
        });
        return volume > 0.0 && std::ranges::all_of(passes, [&](const auto& pass) {
                   const auto reverse = passes.find({pass.first.second, pass.first.first});
                   return pass.second == 1 && reverse != passes.end() && reverse->second == 1;
               });
    }

    dvec3 position(int index) const { return triple(file_.attributes.vertices, index); }

    template <class Numbers>
    static dvec3 triple(const Numbers& numbers, int index) {
        const std::size_t first = static_cast<std::size_t>(index) * 3;
        return {numbers[first], numbers[first + 1], numbers[first + 2]};
    }

    template <class Visit>
    void for_each_corner(Visit visit) const {
        for (const tinyobj::shape_t& shape : file_.shapes) {
            std::ranges::for_each(shape.mesh.indices, visit);
        }
    }

    template <class Visit>
    void for_each_triangle(Visit visit) const {
        for (const tinyobj::shape_t& shape : file_.shapes) {
            const auto& corners = shape.mesh.indices;
            for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
                visit(corners[i].vertex_index, corners[i + 1].vertex_index, corners[i + 2].vertex_index);
            }
        }
    }

    // Only vertices that a face uses count.
    void measure() {
        dvec3 lower{std::numeric_limits<double>::max()};
        dvec3 upper{std::numeric_limits<double>::lowest()};
        for_each_corner([&](const tinyobj::index_t& corner) {
            lower = glm::min(lower, position(corner.vertex_index));
            upper = glm::max(upper, position(corner.vertex_index));
        });
        if (lower.x > upper.x) {
            refuse_model(path_, "has no faces to draw");
        }
        centre_ = 0.5 * (lower + upper);
        double radius = 0.0;
        for_each_corner([&](const tinyobj::index_t& corner) {
            radius = std::max(radius, glm::distance(position(corner.vertex_index), centre_));
        });
        if (radius == 0.0) {
            refuse_model(path_, "is a single point: expected a body with an extent");
        }
        scale_ = 1.0 / radius;
    }

    // Cross products grow with the triangle's area, so that a large face counts for more.
    void sum_face_normals() {
        face_normals_.assign(file_.attributes.vertices.size() / 3, dvec3(0.0));
        for_each_triangle([&](int a, int b, int c) {
            const dvec3 normal = glm::cross(placed(b) - placed(a), placed(c) - placed(a));
            for (const int corner : {a, b, c}) {
                face_normals_[static_cast<std::size_t>(corner)] += normal;
            }
        });
    }

    dvec3 placed(int index) const { return (position(index) - centre_) * scale_; }

    // The file's normal, else the faces', else outwards: a direction in any case.
    vec3 normal(const tinyobj::index_t& corner) const {
        const auto index = static_cast<std::size_t>(corner.vertex_index);
        const dvec3 given =
            corner.normal_index >= 0 ? triple(file_.attributes.normals, corner.normal_index) : dvec3(0.0);
        for (const dvec3& candidate : {given, face_normals_[index], placed(corner.vertex_index)}) {
            const double length = glm::length(candidate);
            if (length > 1e-12 && std::isfinite(length)) {
                return vec3(candidate / length);
            }
        }
        return {0.0f, 0.0f, 1.0f};
    }

    glm::vec2 uv(int index) const {
        if (index < 0) {
            return glm::vec2(0.0f);
        }
        const auto& numbers = file_.attributes.texcoords;
        const std::size_t first = static_cast<std::size_t>(index) * 2;
        // OBJ counts v from the bottom row.
        return {static_cast<float>(numbers[first]), 1.0f - static_cast<float>(numbers[first + 1])};
    }

    std::uint32_t vertex(const tinyobj::index_t& corner) {
        const std::array<int, 3> key = {corner.vertex_index, corner.normal_index, corner.texcoord_index};
        const auto [found, is_new] = known_.try_emplace(key, static_cast<std::uint32_t>(model_.vertices.size()));
        if (is_new) {
            model_.vertices.push_back({vec3(placed(corner.vertex_index)), normal(corner), uv(corner.texcoord_index)});
        }
        return found->second;
    }

    Material make_material(int id) const {
        Material material;
        if (id < 0) {
            return material;
        }
        const tinyobj::material_t& given = file_.materials[static_cast<std::size_t>(id)];
        material.name = given.name;
        material.diffuse = linear_from_srgb(vec3(given.diffuse[0], given.diffuse[1], given.diffuse[2]));
        material.specular = vec3(given.specular[0], given.specular[1], given.specular[2]);
        material.shininess = std::clamp(static_cast<float>(given.shininess), 1.0f, 1000.0f);
        if (!given.diffuse_texname.empty()) {
            material.texture = load_texture(given.diffuse_texname);
        }
        return material;
    }

    Image load_texture(const std::string& name) const {
        Image image;
        try {
            image = load_image(name);
        } catch (const InputError& error) {
            refuse_model(path_, std::string("its texture: ") + error.what());
        }
        if (std::max(image.width, image.height) > largest_texture) {
            refuse_model(
                path_, "its texture " + name + " has more than " + std::to_string(largest_texture) + " pixels a side");
        }
        return image;
    }

    const fs::path& path_;
    const ObjFile& file_;
    dvec3 centre_{0.0};
    double scale_ = 1.0;
    std::vector<dvec3> face_normals_;
    std::map<std::array<int, 3>, std::uint32_t> known_;
    Model model_;
};

}  // namespace

Model load_model(const fs::path& path) {
    const ObjFile file = read_obj(path);
    Model model = Builder(path, file).build();
    fs::path coarse = path;
    coarse.replace_filename(path.stem().string() + "_coarse" + path.extension().string());
    if (fs::exists(coarse)) {
        const ObjFile coarse_file = read_obj(coarse);
        model.coarser.push_back(Builder(coarse, coarse_file).build());
    }
    return model;
}

}  // namespace ballpit::view
