// Every shader in every permutation that a schedule can ask for, and what happens to shaders that are broken.
#include "gpu/programs.h"

#include <filesystem>
#include <fstream>
#include <set>

#include "core/scene.h"
#include "gl/debug.h"
#include "gl/error.h"
#include "support/catch.h"
#include "support/gl_fixture.h"
#include "support/gpu_backend.h"
#include "support/temporary_folder.h"

using namespace ballpit;
using test::GlFixture;

namespace {

// Every program of every schedule: all laws that go together, all settings that are choices.
std::set<Program> all_programs() {
    std::set<Program> programs;
    for (unsigned bits = 0; bits < 64; ++bits) {
        Scene scene;
        scene.laws = {(bits & 1u) != 0, (bits & 2u) != 0, (bits & 4u) != 0, (bits & 8u) != 0, (bits & 16u) != 0};
        scene.balls.resize(1);
        if ((bits & 32u) != 0) {
            scene.balls[0].restitution = 0.5;
        }
        const bool needs_contact = scene.laws.walls || scene.laws.restitution || scene.balls[0].restitution;
        if (needs_contact && !scene.laws.contact) {
            continue;  // the parser refuses it
        }
        for (const SettingInfo& choice : setting_table()) {
            for (const std::string_view name : setting_choices(choice)) {
                for (std::size_t integrator = 0; integrator < integrator_names.size(); ++integrator) {
                    for (const bool limit_force : {false, true}) {
                        Settings settings;
                        settings.integrator = static_cast<Integrator>(integrator);
                        settings.limit_force = limit_force;
                        assign_setting(settings, choice.key, name);
                        const Grid grid = make_grid(dvec3(1), 0.1, 1.0, 5000);
                        const auto schedule = make_schedule(5000, grid, scene_features(scene, settings), settings.sort);
                        for (const Dispatch& dispatch : schedule.dispatches) {
                            programs.insert(dispatch.program);
                        }
                    }
                }
            }
        }
    }
    return programs;
}

bool has_block(const gl::Program& program, const char* block) {
    return glGetProgramResourceIndex(program.id(), GL_SHADER_STORAGE_BLOCK, block) != GL_INVALID_INDEX;
}

GLint block_count(const gl::Program& program) {
    GLint count = 0;
    glGetProgramInterfaceiv(program.id(), GL_SHADER_STORAGE_BLOCK, GL_ACTIVE_RESOURCES, &count);
    return count;
}

// A copy of the shaders that a test may spoil.
class ShaderCopy {
public:
    ShaderCopy() {
        std::filesystem::copy(test::shader_folder(), folder_.path(), std::filesystem::copy_options::recursive);
    }
    const std::filesystem::path& path() const { return folder_.path(); }
    void append(const std::string& file, const std::string& text) const {
        std::ofstream(folder_.path() / file, std::ios::app) << text;
    }
    void remove(const std::string& file) const { std::filesystem::remove(folder_.path() / file); }

private:
    test::TemporaryFolder folder_;
};

std::string complaint_about(const std::filesystem::path& folder, const Program& program) {
    gpu::Programs programs(folder);
    try {
        programs.get(program);
    } catch (const gl::ShaderError& error) {
        gl::take_messages();  // the driver complains here, and is meant to
        return error.what();
    }
    return "compiled";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE_METHOD(GlFixture, "every permutation compiles", "[gpu-programs]") {
    gpu::Programs programs(test::shader_folder());
    const auto wanted = all_programs();
    CHECK(wanted.size() > 150);
    for (const Program& program : wanted) {
        CAPTURE(shader_name(program.shader), program.features.bits);
        CHECK_NOTHROW(programs.get(program));
    }
}

TEST_CASE_METHOD(GlFixture, "a program has the buffers of its laws and no others", "[gpu-programs]") {
    gpu::Programs programs(test::shader_folder());
    const auto& free_flight = programs.get({Shader::collide, Features{}}).program;
    CHECK(block_count(free_flight) == 5);  // state, next state, status
    for (const char* block : {"KeysBlock", "CellRangesBlock", "DampingRatiosBlock"}) {
        CHECK_FALSE(has_block(free_flight, block));
    }
    Features contact;
    contact.add(Feature::contact);
    CHECK(block_count(programs.get({Shader::collide, contact}).program) == 7);
    contact.add(Feature::dashpot);
    contact.add(Feature::ball_restitution);
    CHECK(block_count(programs.get({Shader::collide, contact}).program) == 8);
}

TEST_CASE_METHOD(GlFixture, "a program is compiled once", "[gpu-programs]") {
    gpu::Programs programs(test::shader_folder());
    const GLuint first = programs.get({Shader::clear_cells, {}}).program.id();
    CHECK(programs.get({Shader::clear_cells, {}}).program.id() == first);
}

TEST_CASE_METHOD(GlFixture, "a broken shader is refused with file, line and the driver's words", "[gpu-programs]") {
    const ShaderCopy copy;
    copy.append("clear_cells.comp", "this is no GLSL;\n");
    const std::string in_file = complaint_about(copy.path(), {Shader::clear_cells, {}});
    CHECK(contains(in_file, "clear_cells.comp:"));
    copy.append("shared/cells.glsl", "\nvec3 unknown_type_follows(vec5 a) { return a; }\n");
    const std::string in_include = complaint_about(copy.path(), {Shader::assign_cells, {}});
    CHECK(contains(in_include, "shared/cells.glsl:"));
    CHECK(contains(in_include, "assign_cells"));
}

TEST_CASE_METHOD(GlFixture, "a missing shader and a missing include are refused by name", "[gpu-programs]") {
    const ShaderCopy copy;
    copy.remove("build_grid.comp");
    CHECK(contains(complaint_about(copy.path(), {Shader::build_grid, {}}), "build_grid.comp"));
    copy.remove("shared/keys.glsl");
    const std::string sentence = complaint_about(copy.path(), {Shader::bitonic_sort, {}});
    CHECK(contains(sentence, "keys.glsl"));
    CHECK(contains(sentence, "bitonic_sort.comp"));
    CHECK(contains(complaint_about(copy.path() / "nowhere", {Shader::collide, {}}), "collide.comp"));
}
