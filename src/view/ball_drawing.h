// Draws the balls: as instances of a model, or as ray-cast spheres with the model's first material.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "gl/buffer.h"
#include "gl/vertex_array.h"
#include "view/ball_mesh.h"
#include "view/ball_points.h"
#include "view/ball_programs.h"
#include "view/model.h"
#include "view/picture.h"
#include "view/pixel_balls.h"
#include "view/simple_balls.h"

namespace ballpit::view {

class BallDrawing {
public:
    /// computes: as Renderer has it.
    BallDrawing(const std::filesystem::path& shader_folder, const Model& model, bool computes);

    void set_model(const Model& model);

    /// First of all, for the picture that the following calls draw.
    void prepare(const Picture& picture);
    /// Into a depth map, as the light sees them.
    void draw_shadow_map(const Picture& picture);
    /// Soft dark discs on the ground; to be drawn right after it.
    void draw_contacts(const Picture& picture);
    /// All but those that the overlay makes see-through.
    void draw_balls(const Picture& picture);
    /// Those, over what was drawn before them; only the nearest of them, so that a pile stays as see-through as a ball.
    void draw_ghosts(const Picture& picture);
    /// Velocities, where the overlay asks for them.
    void draw_arrows(const Picture& picture);

private:
    // How the balls of a picture are drawn.
    enum class Way : std::uint8_t {
        instances,  // of a model or a square, each ball
        points,     // each ball, and all of them far
        simple,     // points of the simple look
        pixels,     // balls that are small by pixel, the others as instances
    };

    BallMesh& mesh_for(const Picture& picture);
    void prepare_presences(const Picture& picture);
    Way way_for(const Picture& picture) const;
    void find_pixels(const Picture& picture);
    const gl::Program& use(const BallPrograms& programs) const;
    const gl::Program& use(const LookPrograms& programs, const Picture& picture, bool ghosts) const;
    void point_at_instances(gl::VertexArray& array, const Picture& picture) const;
    void point_at_drawn(gl::VertexArray& array, const Picture& picture) const;
    void draw_look(const Picture& picture, bool ghosts);
    void draw_impostors(const Picture& picture, bool ghosts);
    void draw_models(const Picture& picture, bool ghosts);
    void use_surface(const gl::Program& program, const BallSurface& surface) const;

    LookPrograms model_programs_;
    LookPrograms impostor_programs_;
    BallPrograms shadow_programs_;
    BallPrograms contact_programs_;
    BallPrograms arrow_programs_;
    BallPoints far_balls_;
    std::optional<PixelBalls> pixel_balls_;  // where the context has compute shaders
    SimpleBalls simple_balls_;
    std::vector<BallMesh> meshes_;  // fine, then the coarser one if there is one
    gl::VertexArray square_array_;
    gl::Buffer square_;
    gl::VertexArray ball_array_;
    bool faded_ = false;
    Way way_ = Way::instances;
    std::vector<NearDraw> near_draws_;
    float presence_ = 1.0f;  // of all balls, or, where some are highlighted, of each
    std::vector<float> presences_;
    gl::Buffer presence_buffer_;
};

}  // namespace ballpit::view
