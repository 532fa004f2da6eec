#include "gl/layer.h"

#include <array>
#include <string>

#include "gl/error.h"

namespace ballpit::gl {

void Layer::resize(int width, int height) {
    GLuint id = 0;
    glGenTextures(1, &id);
    texture_ = Handle<delete_texture>(id);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, id);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glGenFramebuffers(1, &id);
    framebuffer_ = Handle<delete_framebuffer>(id);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, id);
    glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.id(), 0);
    if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(before_));
        throw Error("the device cannot draw a layer of " + std::to_string(width) + "x" + std::to_string(height));
    }
    width_ = width;
    height_ = height;
}

void Layer::begin(int width, int height) {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before_);
    if (holds(width, height)) {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.id());
    } else {
        resize(width, height);
        clear(0, 0, width, height);
    }
}

void Layer::clear(int x, int y, int width, int height) const {
    constexpr std::array<GLfloat, 4> nothing{};
    glEnable(GL_SCISSOR_TEST);
    glScissor(x, y, width, height);
    glClearBufferfv(GL_COLOR, 0, nothing.data());
    glDisable(GL_SCISSOR_TEST);
}

void Layer::end() { glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(before_)); }

void Layer::lay_over(int x, int y, int width, int height) const {
    program_.use();
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture_.id());
    no_attributes_.bind();
    glViewport(0, 0, width_, height_);
    glEnable(GL_SCISSOR_TEST);
    glScissor(x, y, width, height);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);  // what was drawn into it is multiplied with its alpha already
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
}

}  // namespace ballpit::gl
