// Dear ImGui on this window: context, backends, font, scale. The only place that knows which ImGui it is.
#pragma once

#include <SDL.h>

#include <filesystem>
#include <string>

#include "gl/context.h"

namespace ballpit::app {

class Gui {
public:
    /// A missing font file is no reason to stop: ImGui's own font stands in for it.
    Gui(const gl::Context& context, std::filesystem::path font_file);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    void process(const SDL_Event& event) const;

    /// Starts a frame. Text is as high as a fixed share of the window's height, times `text_size`: readable from as far
    /// away on every projector.
    void begin_frame(float text_size);
    /// Closes the frame: render() draws the panels of it into what is bound.
    void end_frame() const;
    void render() const;

    /// Where the windows stand that can be moved, as ImGui writes it. Set before the first frame.
    std::string layout() const;
    void set_layout(const std::string& layout);

    bool typing() const;      // a text field has the keyboard
    bool over_panel() const;  // a panel has the mouse
    bool holding() const;     // a slider or field is being changed
    /// This frame's pointer is a hand.
    static void show_hand();

    bool popup_open() const;  // a list is open

private:
    void rescale(float text_size);

    SDL_Window* window_;
    std::filesystem::path font_file_;
    float scale_ = 0.0f;        // of the panels, points
    float pixel_ratio_ = 0.0f;  // pixels a point
};

}  // namespace ballpit::app
