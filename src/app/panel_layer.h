// The panels where a CPU draws: as a layer that is drawn some times a second, and laid over every frame. To draw the
// panels costs a CPU as much as to draw the balls, and their numbers change less often. Of those that changed nothing,
// what was drawn last stays.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "gl/layer.h"

struct ImDrawData;
struct ImDrawList;

namespace ballpit::app {

struct PanelRectangle {
    int left, bottom, right, top;  // pixels from the lower left corner
    bool operator==(const PanelRectangle&) const = default;
};

class PanelLayer {
public:
    /// Throws gl::ShaderError.
    explicit PanelLayer(const std::filesystem::path& shader_folder);

    /// Whether what was drawn last will not do; `lively`: the user does something, or nothing else changes.
    bool due(bool lively, double now_s, int width, int height) const;
    /// Brings the layer up to this frame's ImGui data. `width` x `height`: pixels of the window.
    void draw(double now_s, int width, int height);
    /// Lays what was drawn last over the picture.
    void lay_over() const;

private:
    // Panels that overlap, from back to front: for nothing may be laid over twice.
    struct Area {
        PanelRectangle rectangle;
        std::vector<std::size_t> panels;  // their numbers among the draw lists
        std::vector<std::byte> content;   // what ImGui draws there
        bool operator==(const Area& other) const { return rectangle == other.rectangle && content == other.content; }
    };
    static std::vector<Area> find_areas(const ImDrawData& data, int height);
    void clear(const PanelRectangle& rectangle) const;

    gl::Layer layer_;
    std::vector<Area> areas_;  // no two overlap
    std::optional<double> drawn_s_;
};

}  // namespace ballpit::app
