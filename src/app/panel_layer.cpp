#include "app/panel_layer.h"

#include <imgui.h>
#include <imgui_impl_opengl3.h>

#include <algorithm>
#include <cmath>

#include "view/view_program.h"

namespace ballpit::app {

namespace {

constexpr double longest_s = 1.0 / 15.0;  // that a layer stays: numbers are not read faster

}  // namespace

PanelLayer::PanelLayer(const std::filesystem::path& shader_folder)
    : layer_(view::load_view_program(shader_folder, "layer")) {}

bool PanelLayer::due(bool lively, double now_s, int width, int height) const {
    return lively || !drawn_s_ || now_s - *drawn_s_ > longest_s || !layer_.holds(width, height);
}

void PanelLayer::draw(double now_s, int width, int height) {
    layer_.begin(width, height);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    layer_.end();
    drawn_s_ = now_s;
    find_rectangles(height);
}

// One a window, from what it draws; those that overlap become one, for nothing may be laid over twice.
void PanelLayer::find_rectangles(int height) {
    const ImDrawData& data = *ImGui::GetDrawData();
    rectangles_.clear();
    for (int i = 0; i < data.CmdListsCount; ++i) {
        ImVec2 low(1e9f, 1e9f);
        ImVec2 high(-1e9f, -1e9f);
        for (const ImDrawVert& vertex : data.CmdLists[i]->VtxBuffer) {
            low = {std::min(low.x, vertex.pos.x), std::min(low.y, vertex.pos.y)};
            high = {std::max(high.x, vertex.pos.x), std::max(high.y, vertex.pos.y)};
        }
        if (high.x <= low.x) {
            continue;
        }
        const auto pixel = [](float place, float origin, float scale) { return (place - origin) * scale; };
        const ImVec2 origin = data.DisplayPos;
        const ImVec2 scale = data.FramebufferScale;
        Rectangle found{static_cast<int>(std::floor(pixel(low.x, origin.x, scale.x))),
                        height - static_cast<int>(std::ceil(pixel(high.y, origin.y, scale.y))),
                        static_cast<int>(std::ceil(pixel(high.x, origin.x, scale.x))),
                        height - static_cast<int>(std::floor(pixel(low.y, origin.y, scale.y)))};
        const auto overlaps = [&found](const Rectangle& other) {
            return other.left < found.right && found.left < other.right && other.bottom < found.top &&
                   found.bottom < other.top;
        };
        for (auto other = std::ranges::find_if(rectangles_, overlaps); other != rectangles_.end();
             other = std::ranges::find_if(rectangles_, overlaps)) {
            found = {std::min(found.left, other->left), std::min(found.bottom, other->bottom),
                     std::max(found.right, other->right), std::max(found.top, other->top)};
            rectangles_.erase(other);
        }
        rectangles_.push_back(found);
    }
}

void PanelLayer::lay_over() const {
    for (const Rectangle& r : rectangles_) {
        layer_.lay_over(r.left, r.bottom, r.right - r.left, r.top - r.bottom);
    }
}

}  // namespace ballpit::app
