#include "gl/debug.h"

#include <mutex>
#include <utility>

namespace ballpit::gl {

namespace {

std::mutex mutex;  // a driver may call from a thread of its own
std::vector<std::string> messages;

void GLAD_API_PTR on_message(GLenum, GLenum, GLuint, GLenum severity, GLsizei length, const GLchar* text, const void*) {
    if (severity != GL_DEBUG_SEVERITY_HIGH) {
        return;
    }
    const std::lock_guard lock(mutex);
    messages.emplace_back(text, length < 0 ? std::string_view(text).size() : static_cast<std::size_t>(length));
}

}  // namespace

bool has_debug() { return GLAD_GL_VERSION_4_3 != 0 || GLAD_GL_KHR_debug != 0; }

void label_object(GLenum kind, GLuint id, std::string_view label) {
    if (has_debug()) {
        glObjectLabel(kind, id, static_cast<GLsizei>(label.size()), label.data());
    }
}

DebugGroup::DebugGroup(std::string_view name) {
    if (has_debug()) {
        glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, static_cast<GLsizei>(name.size()), name.data());
    }
}

DebugGroup::~DebugGroup() {
    if (has_debug()) {
        glPopDebugGroup();
    }
}

void collect_messages() {
    if (has_debug()) {
        glEnable(GL_DEBUG_OUTPUT);
        glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        glDebugMessageCallback(on_message, nullptr);
    }
}

std::vector<std::string> take_messages() {
    const std::lock_guard lock(mutex);
    return std::exchange(messages, {});
}

}  // namespace ballpit::gl
