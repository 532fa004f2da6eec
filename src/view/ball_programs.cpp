#include "view/ball_programs.h"

#include "view/view_program.h"

namespace ballpit::view {

BallPrograms::BallPrograms(const std::filesystem::path& shader_folder, const std::string& stem,
                           std::vector<std::string_view> defines)
    : whole(load_view_program(shader_folder, stem, defines)) {
    defines.emplace_back("FADED");
    faded = load_view_program(shader_folder, stem, defines);
}

LookPrograms::LookPrograms(const std::filesystem::path& shader_folder, const std::string& stem)
    : usual(shader_folder, stem),
      valued(shader_folder, stem, {"VALUED"}),
      listed(load_view_program(shader_folder, stem, {"LISTED"})),
      listed_valued(load_view_program(shader_folder, stem, {"LISTED", "VALUED"})) {}

}  // namespace ballpit::view
