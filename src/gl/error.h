// What goes wrong outside: the driver refuses. Thrown at construction, with the driver's own words.
#pragma once

#include <stdexcept>

namespace ballpit::gl {

/// No context, no memory, a limit exceeded.
struct Error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A shader file that is missing, does not compile or does not link; carries file, line and the driver's log.
struct ShaderError : Error {
    using Error::Error;
};

}  // namespace ballpit::gl
