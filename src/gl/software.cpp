#include "gl/software.h"

#include <algorithm>
#include <array>

namespace ballpit::gl {

bool draws_in_software(std::string_view renderer) {
    constexpr std::array<std::string_view, 7> names = {
        "llvmpipe", "softpipe", "swrast", "Software Rasterizer", "SwiftShader", "GDI Generic", "Basic Render"};
    return std::ranges::any_of(names,
                               [&](std::string_view name) { return renderer.find(name) != std::string_view::npos; });
}

}  // namespace ballpit::gl
