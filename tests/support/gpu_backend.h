// The GPU backend of the tests, with the shaders of this source tree.
#pragma once

#include <cstdlib>
#include <memory>

#include "gpu/gpu_backend.h"
#include "support/scenes.h"

namespace ballpit::test {

/// Of this source tree; or of a spoiled copy (tests/mutants.py).
inline std::filesystem::path shader_folder() {
    const char* spoiled = std::getenv("BALLPIT_TEST_SHADERS");
    return spoiled != nullptr ? std::filesystem::path(spoiled) : source_folder() / "glsl";
}

inline std::unique_ptr<gpu::GpuBackend> gpu_backend() { return std::make_unique<gpu::GpuBackend>(shader_folder()); }

/// Mesa's software rasteriser computes in the CPU's own float, correctly rounded: there the GPU must agree with the
/// mirror to the last bit.
inline bool rounds_like_the_cpu(const Backend& backend) {
    return backend.device().find("llvmpipe") != std::string::npos;
}

}  // namespace ballpit::test
