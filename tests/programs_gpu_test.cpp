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

// The features of every set of laws, of balls that differ and that do not, and of all settings that are choices.
std::set<std::uint32_t> all_features() {
    std::set<std::uint32_t> all;
    for (unsigned bits = 0; bits < 1u << law_count; ++bits) {
        Settings settings;
        for (std::size_t i = 0; i < law_count; ++i) {
            settings.laws.*law_table()[i].member = (bits >> i & 1u) != 0;
        }
        for (std::size_t integrator = 0; integrator < integrator_names.size(); ++integrator) {
            settings.integrator = static_cast<Integrator>(integrator);
            for (unsigned choice = 0; choice < 16; ++choice) {
                settings.limit_force = (choice & 1u) != 0;
                settings.neighbours = (choice & 2u) != 0 ? NeighbourSearch::brute_force : NeighbourSearch::grid;
                settings.sorted_copies = (choice & 8u) != 0;
                settings.balls = 1;
                settings.pull = (choice & 4u) != 0 ? std::optional(Pull{}) : std::nullopt;
                all.insert(features_of(settings, {}, settings.laws.shake).bits);
            }
        }
    }
    return all;
}

// Two bits at a time cover what can go wrong between laws; all of them together would take an hour to compile.
std::set<Program> all_programs() {
    std::set<Program> programs;
    std::set<std::pair<std::size_t, unsigned>> seen;  // pair of bits, their values
    const Grid grid = make_grid(dvec3(1), 0.1, 1.0, 5000);
    for (const std::uint32_t bits : all_features()) {
        bool news = false;
        for (std::size_t a = 0; a < feature_defines.size(); ++a) {
            for (std::size_t b = a + 1; b < feature_defines.size(); ++b) {
                const unsigned values = (bits >> a & 1u) * 2u + (bits >> b & 1u);
                news |= seen.insert({a * feature_defines.size() + b, values}).second;
            }
        }
        for (const SortMethod sort : {SortMethod::bitonic, SortMethod::bitonic_fused, SortMethod::counting}) {
            const Schedule schedule = make_schedule(5000, grid, Features{bits}, sort, 2);
            std::vector<Dispatch> dispatches = schedule.dispatches;
            if (can_keep_order(schedule)) {
                std::ranges::copy(there_and_back(schedule).dispatches, std::back_inserter(dispatches));
            }
            for (const Dispatch& dispatch : dispatches) {
                if (news || dispatch.program.shader != Shader::collide) {
                    programs.insert(dispatch.program);
                }
            }
        }
    }
    return programs;
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
    CHECK(wanted.size() > 20);
    for (const Program& program : wanted) {
        CAPTURE(shader_name(program.shader), program.features.bits);
        CHECK_NOTHROW(programs.get(program));
    }
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
