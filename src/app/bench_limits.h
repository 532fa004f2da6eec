// How fast the device copies, and how finely its time can be told, before anything else is believed.
#pragma once

#include <filesystem>

#include "core/backend.h"
#include "measure/device_limits.h"

namespace ballpit::app {

/// Takes about a second. The device copies by a shader, as the stages do; the CPU by memcpy in as many threads as it
/// has cores. Throws gl::ShaderError.
measure::DeviceLimits measure_limits(Backend& backend, const std::filesystem::path& shaders);

}  // namespace ballpit::app
