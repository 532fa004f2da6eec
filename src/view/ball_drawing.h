// Draws the balls: as instances of a model, or as ray-cast spheres with the model's first material.
#pragma once

#include <filesystem>
#include <vector>

#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "gl/vertex_array.h"
#include "view/model.h"
#include "view/picture.h"

namespace ballpit::view {

class BallDrawing {
public:
    BallDrawing(const std::filesystem::path& shader_folder, const Model& model);

    void set_model(const Model& model);

    /// Into a depth map, as the light sees them.
    void draw_shadow_map(const Picture& picture);
    /// Soft dark discs on the ground; to be drawn right after it.
    void draw_contacts(const Picture& picture);
    void draw_balls(const Picture& picture);

private:
    struct Surface {
        GLsizei index_count = 0;
        std::size_t first_index = 0;
        vec3 diffuse{0.0f};
        vec3 specular{0.0f};
        float shininess = 1.0f;
        gl::Texture texture;
    };

    struct Mesh {
        gl::VertexArray array;
        gl::Buffer vertices;
        gl::Buffer indices;
        std::vector<Surface> surfaces;
        bool closed = false;
    };

    static Mesh make_mesh(const Model& model);
    Mesh& mesh_for(const Picture& picture);
    void use_surface(const gl::Program& program, const Surface& surface) const;

    gl::Program model_program_;
    gl::Program impostor_program_;
    gl::Program shadow_program_;
    gl::Program contact_program_;
    std::vector<Mesh> meshes_;  // fine, then the coarser one if there is one
    gl::VertexArray square_array_;
    gl::Buffer square_;
};

}  // namespace ballpit::view
