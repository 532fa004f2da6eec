// Whether a CPU stands in for the GPU.
#pragma once

#include <string_view>

namespace ballpit::gl {

/// `renderer`: of Context::renderer(). The rasterisers that systems fall back on: Mesa's, SwiftShader, and what Windows
/// has without a driver.
bool draws_in_software(std::string_view renderer);

}  // namespace ballpit::gl
