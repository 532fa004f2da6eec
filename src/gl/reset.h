// Whether the driver has thrown the context away: after a hang, a crash or an update of it everything on the device is
// lost. GL tells only who asks (4.5, KHR_robustness or ARB_robustness; where a driver has none of them, nobody knows).
#pragma once

#include <glad/gl.h>

#include <functional>
#include <optional>
#include <string>

#include "gl/error.h"

namespace ballpit::gl {

/// The context is gone, with all that was in it.
struct Lost : Error {
    using Error::Error;
};

/// Asks the driver of the current context from now on, for which nothing is lost yet.
void watch_resets(GLADloadfunc load);

using ResetStatus = std::function<GLenum()>;

/// Asks this in the driver's place, whatever the context, until another or none is given: tests pull the plug with it.
void replace_reset_status(ResetStatus status);

/// Half a sentence that says so, from the first reset on that the driver tells of. Does not wait.
std::optional<std::string> reset_reason();

/// Throws Lost with that.
void expect_context();

}  // namespace ballpit::gl
