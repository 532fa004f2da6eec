// The one hidden OpenGL context that all GPU tests share, and the fixture that makes the driver's complaints
// fail the test in which they came up.
#pragma once

#include "gl/context.h"

namespace ballpit::test {

/// Throws gl::Error where there is no OpenGL 4.3.
void make_context();
void close_context();
gl::Context& context();

/// Base of every GPU test: TEST_CASE_METHOD(GlFixture, ...). At its end, any KHR_debug message of high severity
/// is a failure.
class GlFixture {
public:
    GlFixture();
    ~GlFixture();
    GlFixture(const GlFixture&) = delete;
    GlFixture& operator=(const GlFixture&) = delete;
};

}  // namespace ballpit::test
