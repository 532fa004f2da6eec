// KHR_debug (core in 4.3): names for objects, groups around dispatches, and the driver's messages.
// Everything here does nothing where the context is older.
#pragma once

#include <glad/gl.h>

#include <string>
#include <string_view>
#include <vector>

namespace ballpit::gl {

bool has_debug();

void label_object(GLenum kind, GLuint id, std::string_view label);

/// A named group around the GL calls of its lifetime, as frame debuggers show it.
class DebugGroup {
public:
    explicit DebugGroup(std::string_view name);
    ~DebugGroup();
    DebugGroup(const DebugGroup&) = delete;
    DebugGroup& operator=(const DebugGroup&) = delete;
};

/// Starts collecting the driver's messages of high severity in this context.
void collect_messages();
/// The messages of high severity since the last call, and forgets them.
std::vector<std::string> take_messages();

}  // namespace ballpit::gl
