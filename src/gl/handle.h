// The name of a GL object: owned by one, moved, deleted once.
#pragma once

#include <glad/gl.h>

#include <utility>

namespace ballpit::gl {

template <void (*Delete)(GLuint)>
class Handle {
public:
    Handle() = default;
    explicit Handle(GLuint id) : id_(id) {}
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() {
        if (id_ != 0) {
            Delete(id_);
        }
    }
    GLuint id() const { return id_; }

private:
    GLuint id_ = 0;
};

}  // namespace ballpit::gl
