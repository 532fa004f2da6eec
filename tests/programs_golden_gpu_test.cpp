// Nothing unused is declared: what every program asks for, by the driver's word, against tests/golden/programs.txt.
// Drivers list each member of a std140 block and each storage block that is declared and reached, so a law left in
// without its #ifdef shows as a name that does not belong there.
//
// After a change that is meant, write the file anew and read its diff:
//     SDL_VIDEODRIVER=offscreen ballpit_gpu_tests "[write-golden]"
#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "app/gallery.h"
#include "core/scene_file.h"
#include "core/scene_schedule.h"
#include "gl/debug.h"
#include "gl/error.h"
#include "support/active_resources.h"
#include "support/catch.h"
#include "support/gl_fixture.h"
#include "support/law_scenes.h"
#include "support/shader_copy.h"

using namespace ballpit;
using test::GlFixture;

namespace fs = std::filesystem;

namespace {

using Paragraphs = std::map<std::string, std::string>;  // by title

const fs::path golden_file = test::source_folder() / "tests" / "golden" / "programs.txt";

void add_programs(std::set<Program>& programs, const Scene& scene) {
    for (const Program& program : shipped_programs({&scene, 1})) {
        programs.insert(program);
    }
    if (const Schedule schedule = first_schedule(scene); can_keep_order(schedule)) {
        for (const Dispatch& dispatch : there_and_back(schedule).dispatches) {
            programs.insert(dispatch.program);
        }
    }
}

// Each law alone, each beside contact and walls, and each choice that is a program of its own.
std::set<Program> single_law_programs() {
    std::set<Program> programs;
    for (const LawInfo& law : law_table()) {
        for (const char* others : {"none", "contact,walls"}) {
            Scene scene = test::scene_with(others, 100);
            scene.settings.laws.*law.member = true;
            add_programs(programs, scene);
        }
    }
    for (std::size_t integrator = 0; integrator < integrator_names.size(); ++integrator) {
        for (const char* laws : {"gravity", "drag", "drag,compensated"}) {
            Scene scene = test::scene_with(laws, 100);
            scene.settings.integrator = static_cast<Integrator>(integrator);
            add_programs(programs, scene);
        }
    }
    Scene scene = test::scene_with("contact,restitution,walls", 100);
    scene.settings.limit_force = false;
    add_programs(programs, scene);
    scene.settings.walls_low.x = 0.1;
    add_programs(programs, scene);
    scene.settings.neighbours = NeighbourSearch::brute_force;
    add_programs(programs, scene);
    scene = test::scene_with("none", 100);
    scene.settings.pull = Pull{3, dvec3(0.0)};
    add_programs(programs, scene);
    scene = test::scene_with("contact", 100);
    for (const SortMethod sort : {SortMethod::bitonic, SortMethod::counting}) {
        scene.settings.sort = sort;
        add_programs(programs, scene);
    }
    scene.settings.laws.diagnostics = true;
    scene.settings.grid_reuse = 2;
    add_programs(programs, scene);
    return programs;
}

std::set<Program> golden_programs() {
    std::set<Program> programs = single_law_programs();
    for (const app::SceneEntry& entry : app::list_scenes(test::source_folder() / "assets")) {
        add_programs(programs, load_scene(entry.path));
    }
    return programs;
}

Paragraphs driver_paragraphs(const fs::path& shaders, const std::set<Program>& wanted) {
    gpu::Programs programs(shaders);
    Paragraphs paragraphs;
    for (const Program& program : wanted) {
        paragraphs[test::program_title(program)] = test::program_paragraph(programs, program);
    }
    return paragraphs;
}

Paragraphs golden_paragraphs() {
    Paragraphs paragraphs;
    std::istringstream lines(test::file_text(golden_file));
    std::string title;
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with(" ")) {
            title = line;
        }
        paragraphs[title] += line + "\n";
    }
    return paragraphs;
}

// Whether something shows that these shaders are not the ones of the golden file: a list that differs, or a program
// that does not compile.
bool is_noticed(const fs::path& shaders, const std::set<Program>& wanted, const Paragraphs& golden) {
    gpu::Programs programs(shaders);
    try {
        return std::ranges::any_of(wanted, [&](const Program& program) {
            return test::program_paragraph(programs, program) != golden.at(test::program_title(program));
        });
    } catch (const gl::ShaderError&) {
        gl::take_messages();  // the driver complains, and is meant to
        return true;
    }
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) {
        text += line + "\n";
    }
    return text;
}

std::vector<std::string> lines_of(const fs::path& file) {
    std::vector<std::string> lines;
    std::istringstream text(test::file_text(file));
    for (std::string line; std::getline(text, line);) {
        lines.push_back(line);
    }
    return lines;
}

bool is_conditional(const std::string& line) { return line.starts_with("#if"); }

bool mentions(const std::string& line, std::string_view define) {
    const std::size_t place = line.find(define);
    return place != std::string::npos &&
           (place + define.size() == line.size() || std::string(" )").find(line[place + define.size()]) < 2);
}

// The same lines without the directives of the conditional that starts at `first`: its first branch stays, an #else
// branch goes.
std::vector<std::string> stripped(std::vector<std::string> lines, std::size_t first) {
    int depth = 0;
    bool dropping = false;
    for (std::size_t i = first; i < lines.size(); ++i) {
        const bool at_depth = depth == 1;
        if (is_conditional(lines[i])) {
            ++depth;
            if (i == first) {
                lines[i].clear();
            }
        } else if (at_depth && (lines[i].starts_with("#else") || lines[i].starts_with("#elif"))) {
            dropping = true;
        } else if (lines[i].starts_with("#endif") && --depth == 0) {
            lines[i].clear();
            return lines;
        }
        if (dropping) {
            lines[i].clear();
        }
    }
    return lines;
}

constexpr std::array shader_files = {"collide.comp",           "assign_cells.comp",       "build_grid.comp",
                                     "shared/contact.glsl",    "shared/pair.glsl",        "shared/walls.glsl",
                                     "shared/neighbours.glsl", "shared/brute_force.glsl", "shared/cells.glsl"};

// Conditionals whose code, left in, has no name that a driver could list: a member of a struct that nobody reads,
// another formula (the mirror disagrees: check_gpu_test), or the number of a ball in the place of a constant that is
// declared all the same (ledger_gpu_test finds out which of them is read).
bool leaves_no_name(const std::vector<std::string>& lines, std::size_t first) {
    constexpr std::array codes = {"    float damping_ratio;",
                                  "    force = max(force, 0.0);",
                                  "    precise vec3 way = params.drift * ball.velocity;",
                                  "    return position.w;",
                                  "    return velocity.w;",
                                  "    vec3 left_out;               // of the position"};
    return first + 1 < lines.size() && std::ranges::find(codes, lines[first + 1]) != codes.end();
}

}  // namespace

TEST_CASE_METHOD(GlFixture, "every program asks for what the golden file lists, and nothing else", "[gpu-golden]") {
    const Paragraphs found = driver_paragraphs(test::shader_folder(), golden_programs());
    const Paragraphs golden = golden_paragraphs();
    for (const auto& [title, paragraph] : found) {
        INFO("not (or not so) in " << golden_file << ": if it is meant, see the head of this test for how to renew it");
        CHECK((golden.contains(title) ? golden.at(title) : "") == paragraph);
    }
    for (const auto& [title, paragraph] : golden) {
        INFO(title << " is in the golden file, but no scene and no single law asks for it any longer");
        CHECK(found.contains(title));
    }
}

TEST_CASE_METHOD(GlFixture, "a law compiled in everywhere is noticed", "[gpu-golden]") {
    const std::set<Program> wanted = single_law_programs();
    const Paragraphs golden = golden_paragraphs();
    CHECK_FALSE(is_noticed(test::ShaderCopy().path(), wanted, golden));
    for (const std::string_view define : feature_defines) {
        if (define == "LAW_LIMIT_FORCE" || define == "INTEGRATOR_FORWARD_EULER" || define == "INTEGRATOR_HISTORICAL" ||
            define == "NEIGHBOURS_BRUTE_FORCE" || define == "SMALL_TILES") {
            continue;  // another formula over the same names: check_gpu_test compares with the mirror
        }
        const test::ShaderCopy copy;
        copy.write("shared/dispatch.glsl", "#define " + std::string(define) + "\n" +
                                               test::file_text(test::shader_folder() / "shared/dispatch.glsl"));
        CAPTURE(define);
        CHECK(is_noticed(copy.path(), wanted, golden));
    }
}

TEST_CASE_METHOD(GlFixture, "each single #ifdef of a law that is taken away is noticed", "[gpu-golden]") {
    const std::set<Program> wanted = single_law_programs();
    const Paragraphs golden = golden_paragraphs();
    int spoiled = 0;
    for (const std::string file : shader_files) {
        const std::vector<std::string> lines = lines_of(test::shader_folder() / file);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const bool of_law = is_conditional(lines[i]) && std::ranges::any_of(feature_defines, [&](auto define) {
                                    // Of where the state is read and written and of how much is sorted at once the
                                    // names say nothing; check_gpu_test compares with the mirror.
                                    return define != "SORTED_COPIES" && define != "KEPT_ORDER" &&
                                           define != "SMALL_TILES" && mentions(lines[i], define);
                                });
            if (!of_law || leaves_no_name(lines, i)) {
                continue;
            }
            const test::ShaderCopy copy;
            copy.write(file, joined(stripped(lines, i)));
            INFO(file << ":" << i + 1 << ": " << lines[i]);
            CHECK(is_noticed(copy.path(), wanted, golden));
            ++spoiled;
        }
    }
    CHECK(spoiled > 25);
}

TEST_CASE_METHOD(GlFixture, "writes the golden file anew", "[.][write-golden]") {
    std::ofstream out(golden_file);
    for (const auto& [title, paragraph] : driver_paragraphs(test::shader_folder(), golden_programs())) {
        out << paragraph;
    }
    CHECK(out.good());
}
