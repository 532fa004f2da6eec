// The panels where a CPU draws: as a layer that is drawn some times a second, and laid over every frame. To draw the
// panels costs a CPU as much as to draw the balls, and their numbers change less often.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "gl/layer.h"

namespace ballpit::app {

class PanelLayer {
public:
    /// Throws gl::ShaderError.
    explicit PanelLayer(const std::filesystem::path& shader_folder);

    /// Whether what was drawn last will not do; `lively`: the user does something, or nothing else changes.
    bool due(bool lively, double now_s, int width, int height) const;
    /// Draws the panels of this frame's ImGui data into the layer. `width` x `height`: pixels of the window.
    void draw(double now_s, int width, int height);
    /// Lays what was drawn last over the picture.
    void lay_over() const;

private:
    struct Rectangle {
        int left, bottom, right, top;  // pixels
    };
    void find_rectangles(int height);

    gl::Layer layer_;
    std::vector<Rectangle> rectangles_;  // what the panels cover; no two overlap
    std::optional<double> drawn_s_;
};

}  // namespace ballpit::app
