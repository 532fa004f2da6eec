#include "gl/memory.h"

#include <glad/gl.h>

#include <array>
#include <string_view>

namespace ballpit::gl {

namespace {

// From the extensions' texts: both count in KiB.
constexpr GLenum current_available_memory_nvx = 0x9049;
constexpr GLenum buffer_free_memory_ati = 0x87FB;
constexpr std::size_t kibibyte = 1024;

bool has_extension(std::string_view name) {
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        const auto* text = reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
        if (text != nullptr && name == text) {
            return true;
        }
    }
    return false;
}

}  // namespace

std::optional<std::size_t> free_memory() {
    std::array<GLint, 4> values{};  // ATI: the first is the sum that is free, the second the largest block
    if (has_extension("GL_NVX_gpu_memory_info")) {
        glGetIntegerv(current_available_memory_nvx, values.data());
    } else if (has_extension("GL_ATI_meminfo")) {
        glGetIntegerv(buffer_free_memory_ati, values.data());
    }
    return values[0] > 0 ? std::optional(static_cast<std::size_t>(values[0]) * kibibyte) : std::nullopt;
}

}  // namespace ballpit::gl
