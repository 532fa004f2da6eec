# Debian 12 gives older versions (ImGui 1.86, Catch2 2, GLM 0.9.9), vcpkg and newer distributions newer ones:
# both are looked for here, so that no other file needs to know.

# Third-party headers are -isystem: our warnings are not theirs.
function(ballpit_system_library name)
  get_target_property(directories ${name} INTERFACE_INCLUDE_DIRECTORIES)
  if(directories)
    set_target_properties(${name} PROPERTIES INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${directories}")
  endif()
endfunction()

find_package(glm REQUIRED)
find_package(nlohmann_json 3 REQUIRED)
find_package(CLI11 REQUIRED)
find_package(Threads REQUIRED)
find_path(STB_INCLUDE_DIR stb_image.h PATH_SUFFIXES stb REQUIRED)
add_library(ballpit_stb INTERFACE)
target_include_directories(ballpit_stb SYSTEM INTERFACE ${STB_INCLUDE_DIR})

if(BALLPIT_GL)
  find_package(SDL2 REQUIRED)
  find_package(tinyobjloader REQUIRED)
  find_package(imgui CONFIG QUIET)
  if(NOT TARGET imgui::imgui)
    find_package(PkgConfig REQUIRED)
    pkg_check_modules(imgui REQUIRED IMPORTED_TARGET imgui)
    add_library(ballpit_imgui INTERFACE)
    # The backends' headers lie in a folder of their own there, beside imgui.h in vcpkg.
    target_include_directories(ballpit_imgui SYSTEM INTERFACE ${imgui_INCLUDE_DIRS} ${imgui_INCLUDE_DIRS}/backends)
    target_link_libraries(ballpit_imgui INTERFACE PkgConfig::imgui)
    add_library(imgui::imgui ALIAS ballpit_imgui)
  endif()

  # glad 2, generated here from the specification that the generator carries: nothing is downloaded.
  find_program(GLAD_GENERATOR glad REQUIRED)
  set(glad_dir ${PROJECT_BINARY_DIR}/glad)
  add_custom_command(
    OUTPUT ${glad_dir}/src/gl.c ${glad_dir}/include/glad/gl.h
    COMMAND ${GLAD_GENERATOR} --quiet --api gl:core=4.3 --extensions GL_KHR_debug,GL_ARB_robustness
            --out-path ${glad_dir} --reproducible c
    COMMENT "Generating the OpenGL 4.3 loader"
    VERBATIM)
  add_library(ballpit_glad STATIC ${glad_dir}/src/gl.c)
  target_include_directories(ballpit_glad SYSTEM PUBLIC ${glad_dir}/include)
endif()
