#include "gl/reset.h"

#include <array>
#include <utility>

namespace ballpit::gl {

namespace {

// From the extensions' texts: the loader knows 4.3 only.
constexpr GLenum guilty_context_reset = 0x8253;
constexpr GLenum innocent_context_reset = 0x8254;

using StatusFunction = GLenum(GLAD_API_PTR*)();

StatusFunction of_driver = nullptr;
ResetStatus in_its_place;
GLenum seen = GL_NO_ERROR;  // a driver that has recovered says again that there is no error

GLenum reset_status() {
    if (in_its_place) {
        return in_its_place();
    }
    return of_driver != nullptr ? of_driver() : static_cast<GLenum>(GL_NO_ERROR);
}

std::string cause_of(GLenum status) {
    switch (status) {
        case guilty_context_reset:
            return "after something that this program asked for";
        case innocent_context_reset:
            return "because of another program";
        default:
            return "for a reason that it does not know";
    }
}

}  // namespace

void watch_resets(GLADloadfunc load) {
    constexpr std::array names = {"glGetGraphicsResetStatus", "glGetGraphicsResetStatusKHR",
                                  "glGetGraphicsResetStatusARB"};
    of_driver = nullptr;
    seen = GL_NO_ERROR;
    for (const char* name : names) {
        if (of_driver == nullptr) {
            of_driver = reinterpret_cast<StatusFunction>(load(name));
        }
    }
}

void replace_reset_status(ResetStatus status) {
    in_its_place = std::move(status);
    seen = GL_NO_ERROR;
}

std::optional<std::string> reset_reason() {
    if (seen == GL_NO_ERROR) {
        seen = reset_status();
    }
    return seen == GL_NO_ERROR ? std::nullopt
                               : std::optional("the graphics driver was reset, " + cause_of(seen) +
                                               ", and what was on the device is lost");
}

void expect_context() {
    if (const auto reason = reset_reason()) {
        throw Lost(*reason);
    }
}

}  // namespace ballpit::gl
