// The driver's view of shared/layout.h against C++'s: offsets, strides, bindings and group sizes.
#include <cstddef>
#include <string>

#include "core/layout.h"
#include "gpu/programs.h"
#include "support/catch.h"
#include "support/gl_fixture.h"
#include "support/gpu_backend.h"

using namespace ballpit;
using test::GlFixture;

namespace {

GLint property(GLuint program, GLenum interface, const std::string& name, GLenum what) {
    const GLuint index = glGetProgramResourceIndex(program, interface, name.c_str());
    CAPTURE(name);
    REQUIRE(index != GL_INVALID_INDEX);
    GLint value = -1;
    glGetProgramResourceiv(program, interface, index, 1, &what, 1, nullptr, &value);
    return value;
}

GLint offset(GLuint program, const std::string& variable) {
    return property(program, GL_BUFFER_VARIABLE, variable, GL_OFFSET);
}

GLint stride(GLuint program, const std::string& variable) {
    return property(program, GL_BUFFER_VARIABLE, variable, GL_TOP_LEVEL_ARRAY_STRIDE);
}

GLint binding(GLuint program, const std::string& block) {
    return property(program, GL_SHADER_STORAGE_BLOCK, block, GL_BUFFER_BINDING);
}

Features all_laws() {
    Features features;
    for (const Feature law : {Feature::gravity, Feature::drag, Feature::contact, Feature::dashpot, Feature::limit_force,
                              Feature::walls, Feature::ball_restitution, Feature::diagnostics}) {
        features.add(law);
    }
    return features;
}

class LayoutTest : public GlFixture {
public:
    GLuint id_of(Shader shader) {
        const Features features = all_laws();
        return programs_.get({shader, features}).program.id();
    }

private:
    gpu::Programs programs_{test::shader_folder()};
};

}  // namespace

TEST_CASE_METHOD(LayoutTest, "the uniform block of every shader has its binding", "[gpu-layout]") {
    for (const Shader shader :
         {Shader::assign_cells, Shader::bitonic_sort, Shader::bitonic_sort_fused, Shader::bitonic_sort_strides,
          Shader::clear_cells, Shader::build_grid, Shader::count_cells, Shader::count_tiles, Shader::scan_cells,
          Shader::scatter_keys, Shader::order_keys, Shader::count_missed, Shader::keep_places, Shader::gather,
          Shader::collide}) {
        CAPTURE(shader_name(shader));
        CHECK(property(id_of(shader), GL_UNIFORM_BLOCK, "ParamsBlock", GL_BUFFER_BINDING) == BLOCK_PARAMS);
    }
}

TEST_CASE_METHOD(LayoutTest, "keys, ranges and status lie as in C++", "[gpu-layout]") {
    const GLuint assign = id_of(Shader::assign_cells);
    CHECK(offset(assign, "keys[0].cell_id") == offsetof(Key, cell_id));
    CHECK(offset(assign, "keys[0].ball_id") == offsetof(Key, ball_id));
    CHECK(stride(assign, "keys[0].cell_id") == sizeof(Key));
    CHECK(offset(assign, "status.bits") == offsetof(Status, bits));
    CHECK(offset(assign, "status.not_finite") == offsetof(Status, not_finite));
    CHECK(offset(assign, "status.out_of_bounds") == offsetof(Status, out_of_bounds));
    CHECK(offset(assign, "status.over_capacity") == offsetof(Status, over_capacity));
    CHECK(offset(assign, "status.missed") == offsetof(Status, missed));
    CHECK(offset(assign, "status.drift_bits") == offsetof(Status, drift_bits));
    const GLuint build = id_of(Shader::build_grid);
    CHECK(offset(build, "cell_ranges[0].first") == offsetof(CellRange, first));
    CHECK(offset(build, "cell_ranges[0].end") == offsetof(CellRange, end));
    CHECK(stride(build, "cell_ranges[0].first") == sizeof(CellRange));
}

TEST_CASE_METHOD(LayoutTest, "the state is tightly packed", "[gpu-layout]") {
    const GLuint collide = id_of(Shader::collide);
    for (const char* array : {"positions", "velocities", "next_positions", "next_velocities"}) {
        CHECK(offset(collide, std::string(array) + "[0]") == 0);
        CHECK(property(collide, GL_BUFFER_VARIABLE, std::string(array) + "[0]", GL_ARRAY_STRIDE) == sizeof(vec4));
    }
    CHECK(property(collide, GL_BUFFER_VARIABLE, "damping_ratios[0]", GL_ARRAY_STRIDE) == sizeof(float));
}

TEST_CASE_METHOD(LayoutTest, "every block has its slot's binding", "[gpu-layout]") {
    const GLuint collide = id_of(Shader::collide);
    CHECK(binding(collide, "PositionsBlock") == SLOT_POSITIONS);
    CHECK(binding(collide, "VelocitiesBlock") == SLOT_VELOCITIES);
    CHECK(binding(collide, "DampingRatiosBlock") == SLOT_DAMPING_RATIOS);
    CHECK(binding(collide, "KeysBlock") == SLOT_KEYS);
    CHECK(binding(collide, "CellRangesBlock") == SLOT_CELL_RANGES);
    CHECK(binding(collide, "StatusBlock") == SLOT_STATUS);
    CHECK(binding(collide, "NextPositionsBlock") == SLOT_NEXT_POSITIONS);
    CHECK(binding(collide, "NextVelocitiesBlock") == SLOT_NEXT_VELOCITIES);
    CHECK(binding(id_of(Shader::assign_cells), "PositionsBlock") == SLOT_POSITIONS);
    CHECK(binding(id_of(Shader::assign_cells), "KeysBlock") == SLOT_KEYS);
    CHECK(binding(id_of(Shader::bitonic_sort), "KeysBlock") == SLOT_KEYS);
    CHECK(binding(id_of(Shader::bitonic_sort_fused), "KeysBlock") == SLOT_KEYS);
    CHECK(binding(id_of(Shader::clear_cells), "CellRangesBlock") == SLOT_CELL_RANGES);
    CHECK(binding(id_of(Shader::build_grid), "CellRangesBlock") == SLOT_CELL_RANGES);
    CHECK(binding(id_of(Shader::count_missed), "BuiltPositionsBlock") == SLOT_BUILT_POSITIONS);
    CHECK(binding(id_of(Shader::keep_places), "BuiltPositionsBlock") == SLOT_BUILT_POSITIONS);
}

TEST_CASE_METHOD(LayoutTest, "work groups have the sizes that the schedule counts with", "[gpu-layout]") {
    for (const Shader shader :
         {Shader::assign_cells, Shader::bitonic_sort, Shader::bitonic_sort_fused, Shader::clear_cells,
          Shader::build_grid, Shader::count_missed, Shader::keep_places, Shader::collide}) {
        std::array<GLint, 3> size{};
        glGetProgramiv(id_of(shader), GL_COMPUTE_WORK_GROUP_SIZE, size.data());
        CAPTURE(shader_name(shader));
        const bool by_tile =
            shader == Shader::clear_cells || shader == Shader::count_tiles || shader == Shader::scan_cells;
        CHECK(size[0] == (shader == Shader::bitonic_sort_fused ? SORT_GROUP_SIZE
                          : by_tile                            ? TILE_GROUP_SIZE
                                                               : GROUP_SIZE));
        CHECK(size[1] == 1);
        CHECK(size[2] == 1);
    }
}

TEST_CASE_METHOD(LayoutTest, "what OpenGL 4.3 guarantees is enough", "[gpu-layout]") {
    CHECK(SORT_TILE_SIZE * sizeof(Key) <= 32768);  // GL_MAX_COMPUTE_SHARED_MEMORY_SIZE
    CHECK(SORT_GROUP_SIZE <= 1024);                // GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS
    CHECK(SLOT_COMPENSATIONS == 8);                // GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS; beyond, devices are asked
    CHECK(SLOT_COUNT == 17);
    CHECK(STRIDE_KEYS * SORT_GROUP_SIZE == SORT_TILE_SIZE);
    CHECK(STRIDE_KEYS * SORT_SMALL_GROUP_SIZE == SORT_SMALL_TILE_SIZE);
}
