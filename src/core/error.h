// Errors from outside, told by kind: main() turns each into one sentence and an exit code.
#pragma once

#include <stdexcept>

namespace ballpit {

/// Bad command line or file (exit code 2). The message names file, place and what was expected.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// No usable OpenGL, or the device is out of memory (exit code 3).
struct DeviceError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The device has no room for what was asked for, and what ran there before still stands.
struct NoRoom : DeviceError {
    using DeviceError::DeviceError;
};

}  // namespace ballpit
