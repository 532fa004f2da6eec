#include "gl/framebuffer.h"

#include <algorithm>
#include <string>

#include "gl/error.h"

namespace ballpit::gl {

Framebuffer::Framebuffer(int width, int height) : width_(width), height_(height) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    if (width < 1 || height < 1 || width > largest || height > largest) {
        throw Error("a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                    " is not possible on this device: expected 1x1 to " + std::to_string(largest) + "x" +
                    std::to_string(largest));
    }
    GLuint id = 0;
    glGenFramebuffers(1, &id);
    framebuffer_ = Handle<delete_framebuffer>(id);
    glBindFramebuffer(GL_FRAMEBUFFER, id);
    glGenRenderbuffers(1, &id);
    colour_ = Handle<delete_renderbuffer>(id);
    glBindRenderbuffer(GL_RENDERBUFFER, id);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, id);
    glGenRenderbuffers(1, &id);
    depth_ = Handle<delete_renderbuffer>(id);
    glBindRenderbuffer(GL_RENDERBUFFER, id);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, id);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw Error("the device cannot draw a picture of " + std::to_string(width) + "x" + std::to_string(height));
    }
}

void Framebuffer::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glViewport(0, 0, width_, height_);
}

std::vector<unsigned char> Framebuffer::pixels() const {
    bind();
    return read_pixels(width_, height_);
}

std::vector<unsigned char> read_pixels(int width, int height) {
    const auto row = static_cast<std::size_t>(width) * 3;
    std::vector<unsigned char> upside_down(row * static_cast<std::size_t>(height));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, upside_down.data());
    std::vector<unsigned char> pixels(upside_down.size());
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
        const auto from =
            upside_down.begin() + static_cast<std::ptrdiff_t>((static_cast<std::size_t>(height) - 1 - y) * row);
        std::copy_n(from, row, pixels.begin() + static_cast<std::ptrdiff_t>(y * row));
    }
    return pixels;
}

}  // namespace ballpit::gl
