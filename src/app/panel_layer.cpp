#include "app/panel_layer.h"

#include <imgui.h>
#include <imgui_impl_opengl3.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include "view/view_program.h"

namespace ballpit::app {

namespace {

constexpr double longest_s = 1.0 / 15.0;  // that a layer stays: numbers are not read faster

template <class T>
void append(std::vector<std::byte>& content, const T* elements, int count) {
    const auto bytes = std::as_bytes(std::span(elements, static_cast<std::size_t>(count)));
    content.insert(content.end(), bytes.begin(), bytes.end());
}

// All that says what a list draws, but for the textures' texels: whatever changes those moves letters, too.
void append(std::vector<std::byte>& content, const ImDrawList& list) {
    append(content, list.VtxBuffer.Data, list.VtxBuffer.Size);
    append(content, list.IdxBuffer.Data, list.IdxBuffer.Size);
    for (const ImDrawCmd& command : list.CmdBuffer) {
        append(content, &command.ClipRect, 1);
        append(content, &command.ElemCount, 1);
    }
}

// The same picture with these lists only.
void render(const ImDrawData& data, const std::vector<std::size_t>& panels) {
    ImDrawData part = data;
#if IMGUI_VERSION_NUM >= 18980
    part.CmdLists.resize(0);
    for (const std::size_t panel : panels) {
        part.CmdLists.push_back(data.CmdLists[static_cast<int>(panel)]);
    }
#else
    std::vector<ImDrawList*> lists;
    std::ranges::transform(panels, std::back_inserter(lists),
                           [&data](std::size_t panel) { return data.CmdLists[panel]; });
    part.CmdLists = lists.data();
#endif
    part.CmdListsCount = static_cast<int>(panels.size());
    ImGui_ImplOpenGL3_RenderDrawData(&part);
}

// From what it draws; none where that is nothing.
std::optional<PanelRectangle> rectangle_of(const ImDrawList& list, const ImDrawData& data, int height) {
    ImVec2 low(1e9f, 1e9f);
    ImVec2 high(-1e9f, -1e9f);
    for (const ImDrawVert& vertex : list.VtxBuffer) {
        low = {std::min(low.x, vertex.pos.x), std::min(low.y, vertex.pos.y)};
        high = {std::max(high.x, vertex.pos.x), std::max(high.y, vertex.pos.y)};
    }
    if (high.x <= low.x) {
        return std::nullopt;
    }
    const auto pixel = [](float place, float origin, float scale) { return (place - origin) * scale; };
    const ImVec2 origin = data.DisplayPos;
    const ImVec2 scale = data.FramebufferScale;
    return PanelRectangle{static_cast<int>(std::floor(pixel(low.x, origin.x, scale.x))),
                          height - static_cast<int>(std::ceil(pixel(high.y, origin.y, scale.y))),
                          static_cast<int>(std::ceil(pixel(high.x, origin.x, scale.x))),
                          height - static_cast<int>(std::floor(pixel(low.y, origin.y, scale.y)))};
}

bool overlap(const PanelRectangle& a, const PanelRectangle& b) {
    return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

PanelRectangle around(const PanelRectangle& a, const PanelRectangle& b) {
    return {std::min(a.left, b.left), std::min(a.bottom, b.bottom), std::max(a.right, b.right), std::max(a.top, b.top)};
}

}  // namespace

PanelLayer::PanelLayer(const std::filesystem::path& shader_folder)
    : layer_(view::load_view_program(shader_folder, "layer")) {}

bool PanelLayer::due(bool lively, double now_s, int width, int height) const {
    return lively || !drawn_s_ || now_s - *drawn_s_ > longest_s || !layer_.holds(width, height);
}

void PanelLayer::draw(double now_s, int width, int height) {
    const ImDrawData& data = *ImGui::GetDrawData();
    drawn_s_ = now_s;
    if (!layer_.holds(width, height)) {
        areas_.clear();
    }
    std::vector<Area> areas = find_areas(data, height);
    if (layer_.holds(width, height) && areas == areas_) {
        return;
    }
    const std::vector<Area> before = std::exchange(areas_, std::move(areas));
    layer_.begin(width, height);
    for (const Area& area : before) {
        if (std::ranges::find(areas_, area) == areas_.end()) {
            clear(area.rectangle);
        }
    }
    for (const Area& area : areas_) {
        if (std::ranges::find(before, area) == before.end()) {
            render(data, area.panels);
        }
    }
    layer_.end();
}

void PanelLayer::clear(const PanelRectangle& r) const {
    layer_.clear(r.left, r.bottom, r.right - r.left, r.top - r.bottom);
}

std::vector<PanelLayer::Area> PanelLayer::find_areas(const ImDrawData& data, int height) {
    std::vector<Area> areas;
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const std::optional<PanelRectangle> covered = rectangle_of(*data.CmdLists[i], data, height);
        if (!covered) {
            continue;
        }
        Area found{*covered, {static_cast<std::size_t>(i)}, {}};
        const auto overlaps = [&found](const Area& other) { return overlap(found.rectangle, other.rectangle); };
        for (auto other = std::ranges::find_if(areas, overlaps); other != areas.end();
             other = std::ranges::find_if(areas, overlaps)) {
            found.rectangle = around(found.rectangle, other->rectangle);
            found.panels.insert(found.panels.end(), other->panels.begin(), other->panels.end());
            areas.erase(other);
        }
        std::ranges::sort(found.panels);  // ImGui's order is from back to front
        areas.push_back(std::move(found));
    }
    for (Area& area : areas) {
        for (const std::size_t panel : area.panels) {
            append(area.content, *data.CmdLists[static_cast<int>(panel)]);
        }
    }
    return areas;
}

void PanelLayer::lay_over() const {
    for (const Area& area : areas_) {
        const PanelRectangle& r = area.rectangle;
        layer_.lay_over(r.left, r.bottom, r.right - r.left, r.top - r.bottom);
    }
}

}  // namespace ballpit::app
