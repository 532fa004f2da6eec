#include "view/pixel_balls.h"

#include <algorithm>

#include "view/far_balls.h"
#include "view/view_program.h"

namespace ballpit::view {

namespace {

constexpr std::size_t bytes_a_pixel = 8;  // PixelBall of glsl/shared/pixel_balls.glsl
static_assert(sizeof(NearBall) == 48 && offsetof(NearBall, number) == 36);

// By ray a ball looks as the impostor does, however large; from here on a group of triangles is less work than a thread
// that goes through so many pixels. A model need not be a sphere: it is drawn until nobody can tell.
constexpr float near_impostor_from = 16.0f;

// Work groups of so many threads each for all of them.
GLuint groups(std::size_t threads, std::size_t size) { return static_cast<GLuint>((threads + size - 1) / size); }

std::size_t bytes_of_pixels(const Picture& picture) {
    return static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height) * bytes_a_pixel;
}

std::size_t bytes_of_list(const Picture& picture) { return picture.ball_count * sizeof(NearBall); }

void provide(gl::Buffer& buffer, std::string_view label, std::size_t bytes) {
    if (buffer.size() < bytes) {
        buffer = gl::Buffer(label, bytes);
    }
}

}  // namespace

bool PixelBalls::possible() { return GLAD_GL_VERSION_4_3 != 0; }

PixelBalls::PixelBalls(const std::filesystem::path& shader_folder)
    : clear_(load_compute_program(shader_folder, "pixel_balls_clear")),
      find_(load_compute_program(shader_folder, "pixel_balls")),
      usual_(load_view_program(shader_folder, "pixel_balls")),
      valued_(load_view_program(shader_folder, "pixel_balls", {"VALUED"})) {
    GLint64 bytes = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
    largest_block_ = static_cast<std::size_t>(bytes);
}

bool PixelBalls::can_draw(const Picture& picture) const {
    return picture.ball_count >= far_from && bytes_of_pixels(picture) <= largest_block_ &&
           bytes_of_list(picture) <= largest_block_;
}

// The buffers change places every substep, hence anew for each picture.
void PixelBalls::find(const Picture& picture, bool valued, std::span<const NearDraw> draws) {
    provide(pixels_, "balls of the pixels", bytes_of_pixels(picture));
    provide(near_balls_, "near balls", bytes_of_list(picture));
    provide(near_draws_, "draws of near balls", draws.size_bytes());
    // The picture before may still be working with all three of them.
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
    near_draws_.write(std::as_bytes(draws));
    const gl::Buffer& velocities = picture.velocities != nullptr ? *picture.velocities : *picture.positions;
    const gl::Buffer& values = valued ? *picture.values : *picture.positions;
    picture.positions->bind_base(GL_SHADER_STORAGE_BUFFER, BINDING_DRAWN_POSITIONS);
    velocities.bind_base(GL_SHADER_STORAGE_BUFFER, BINDING_DRAWN_VELOCITIES);
    values.bind_base(GL_SHADER_STORAGE_BUFFER, BINDING_DRAWN_VALUES);
    pixels_.bind_base(GL_SHADER_STORAGE_BUFFER, BINDING_PIXELS);
    near_balls_.bind_base(GL_SHADER_STORAGE_BUFFER, BINDING_NEAR_BALLS);
    near_draws_.bind_base(GL_SHADER_STORAGE_BUFFER, BINDING_NEAR_DRAWS);
    clear_.use();
    glDispatchCompute(groups(static_cast<std::size_t>(picture.width), PIXELS_GROUP_WIDTH),
                      groups(static_cast<std::size_t>(picture.height), PIXELS_GROUP_WIDTH), 1);
    find_.use();
    glUniform1ui(find_.uniform("ball_count"), picture.ball_count);
    glUniform1ui(find_.uniform("draw_count"), static_cast<GLuint>(draws.size()));
    glUniform1f(find_.uniform("near_from"), picture.look == Look::model ? far_below : near_impostor_from);
    glUniform1i(find_.uniform("valued"), valued ? 1 : 0);
    for (const bool naming : {false, true}) {
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        glUniform1i(find_.uniform("naming"), naming ? 1 : 0);
        glDispatchCompute(groups(picture.ball_count, PIXEL_BALLS_GROUP_SIZE), 1, 1);
    }
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
}

const gl::Program& PixelBalls::use(bool valued) const {
    const gl::Program& program = valued ? valued_ : usual_;
    program.use();
    return program;
}

void PixelBalls::draw() const {
    no_attributes_.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

const void* PixelBalls::bind_draw(std::size_t draw) const {
    near_draws_.bind(GL_DRAW_INDIRECT_BUFFER);
    return reinterpret_cast<const void*>(draw * sizeof(NearDraw));
}

}  // namespace ballpit::view
