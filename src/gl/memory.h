// The device's memory, as far as the driver tells.
#pragma once

#include <cstddef>
#include <optional>

namespace ballpit::gl {

/// Bytes that are free for buffers, by GL_NVX_gpu_memory_info or GL_ATI_meminfo; nothing where neither is there. What a
/// driver promises is not binding: others use the device, too.
std::optional<std::size_t> free_memory();

}  // namespace ballpit::gl
