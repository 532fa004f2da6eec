# Debian 12 gives older versions (ImGui 1.86, Catch2 2, GLM 0.9.9), vcpkg and newer distributions newer ones:
# both are looked for here, so that no other file needs to know.

include(cmake/fetch.cmake)

find_package(glm REQUIRED)
find_package(nlohmann_json 3 REQUIRED)
find_package(CLI11 REQUIRED)
find_package(Threads REQUIRED)

find_path(STB_INCLUDE_DIR stb_image.h PATH_SUFFIXES stb)
if(NOT STB_INCLUDE_DIR)
  ballpit_fetch(stb https://github.com/nothings/stb 5c205738c191bcb0abc65c4febfa9bd25ff35234)
  set(STB_INCLUDE_DIR ${stb_SOURCE_DIR})
endif()
add_library(ballpit_stb INTERFACE)
target_include_directories(ballpit_stb SYSTEM INTERFACE ${STB_INCLUDE_DIR})

if(NOT BALLPIT_GL)
  return()
endif()

find_package(SDL2 REQUIRED)

find_package(tinyobjloader CONFIG QUIET)
if(NOT TARGET tinyobjloader::tinyobjloader)
  ballpit_fetch(tinyobjloader https://github.com/tinyobjloader/tinyobjloader v2.0.0rc13)
  add_library(ballpit_tinyobjloader STATIC ${tinyobjloader_SOURCE_DIR}/tiny_obj_loader.cc)
  target_include_directories(ballpit_tinyobjloader SYSTEM PUBLIC ${tinyobjloader_SOURCE_DIR})
  add_library(tinyobjloader::tinyobjloader ALIAS ballpit_tinyobjloader)
endif()

# imgui::imgui with its SDL2 and OpenGL 3 backends: vcpkg's package, Debian's, or built here. Other packages exist,
# but most of them leave the SDL2 backend out.
find_package(imgui CONFIG QUIET)
if(NOT TARGET imgui::imgui)
  find_package(PkgConfig QUIET)
  if(PKG_CONFIG_FOUND)
    pkg_check_modules(imgui QUIET imgui)
    # The backends' headers lie in a folder of their own there, beside imgui.h in vcpkg.
    find_path(IMGUI_BACKENDS_DIR NAMES imgui_impl_sdl2.h imgui_impl_sdl.h
              PATHS ${imgui_INCLUDE_DIRS} PATH_SUFFIXES backends NO_DEFAULT_PATH)
  endif()
  if(imgui_FOUND AND IMGUI_BACKENDS_DIR)
    # Debian's is a static library that does not say that its SDL2 backend needs SDL2.
    find_library(IMGUI_LIBRARY imgui HINTS ${imgui_LIBRARY_DIRS} REQUIRED)
    add_library(ballpit_imgui UNKNOWN IMPORTED)
    set_target_properties(ballpit_imgui PROPERTIES IMPORTED_LOCATION ${IMGUI_LIBRARY})
    target_include_directories(ballpit_imgui SYSTEM INTERFACE ${imgui_INCLUDE_DIRS} ${IMGUI_BACKENDS_DIR})
    target_link_libraries(ballpit_imgui INTERFACE ${imgui_LINK_LIBRARIES} SDL2::SDL2 ${CMAKE_DL_LIBS})
  else()
    ballpit_fetch(imgui https://github.com/ocornut/imgui v1.91.5)
    file(GLOB imgui_sources ${imgui_SOURCE_DIR}/*.cpp)
    add_library(ballpit_imgui STATIC ${imgui_sources} ${imgui_SOURCE_DIR}/backends/imgui_impl_sdl2.cpp
                ${imgui_SOURCE_DIR}/backends/imgui_impl_opengl3.cpp)
    target_include_directories(ballpit_imgui SYSTEM PUBLIC ${imgui_SOURCE_DIR} ${imgui_SOURCE_DIR}/backends)
    target_link_libraries(ballpit_imgui PUBLIC SDL2::SDL2 ${CMAKE_DL_LIBS})
  endif()
  add_library(imgui::imgui ALIAS ballpit_imgui)
endif()

# glad 2, generated here from the specification that the generator carries: where it is installed nothing is downloaded.
find_program(GLAD_GENERATOR glad)
if(NOT GLAD_GENERATOR)
  ballpit_fetch_glad()
endif()
set(glad_dir ${PROJECT_BINARY_DIR}/glad)
add_custom_command(
  OUTPUT ${glad_dir}/src/gl.c ${glad_dir}/include/glad/gl.h
  COMMAND ${GLAD_GENERATOR} --quiet --api gl:core=4.3 --extensions GL_KHR_debug,GL_ARB_robustness
          --out-path ${glad_dir} --reproducible c
  COMMENT "Generating the OpenGL 4.3 loader"
  VERBATIM)
add_library(ballpit_glad STATIC ${glad_dir}/src/gl.c)
target_include_directories(ballpit_glad SYSTEM PUBLIC ${glad_dir}/include)
