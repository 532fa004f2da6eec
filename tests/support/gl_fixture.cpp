#include "support/gl_fixture.h"

#include <memory>

#include "gl/debug.h"
#include "gl/error.h"
#include "support/catch.h"

namespace ballpit::test {

namespace {

std::unique_ptr<gl::Context>& shared_context() {
    static std::unique_ptr<gl::Context> context;
    return context;
}

}  // namespace

void make_context() {
    auto made = std::make_unique<gl::Context>(
        gl::ContextOptions{.title = "Ball Pit tests", .width = 320, .height = 240, .visible = false, .debug = true});
    if (!made->has_compute()) {
        throw gl::Error("this context has OpenGL " + made->version());
    }
    gl::collect_messages();
    shared_context() = std::move(made);
}

void close_context() { shared_context().reset(); }

gl::Context& context() { return *shared_context(); }

GlFixture::GlFixture() { gl::take_messages(); }

GlFixture::~GlFixture() {
    for (const std::string& message : gl::take_messages()) {
        FAIL_CHECK("the driver complains: " << message);
    }
}

}  // namespace ballpit::test
