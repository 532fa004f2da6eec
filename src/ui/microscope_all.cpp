// All keys of the sort as one picture: across the slots, up the cell ids.
#include <algorithm>
#include <cfloat>

#include "ui/microscope_scope.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

// Where the picture lies, in pixels.
struct Plot {
    ImVec2 low;
    float width = 0.0f;
    float height = 0.0f;
    float right() const { return low.x + width; }
    float bottom() const { return low.y + height; }
};

ImDrawList& canvas() { return *ImGui::GetWindowDrawList(); }

// The keys that share a column of pixels.
struct Column {
    std::uint32_t least = SENTINEL;  // cell ids; SENTINEL: nothing but padding
    std::uint32_t most = 0;
    std::uint32_t ball = 0;
};

Column column_of(std::span<const Key> keys) {
    constexpr std::size_t most_samples = 64;  // of millions of keys
    const std::size_t stride = std::max<std::size_t>(1, keys.size() / most_samples);
    Column column;
    for (std::size_t i = 0; i < keys.size(); i += stride) {
        if (keys[i].cell_id != SENTINEL) {
            column.least = std::min(column.least, keys[i].cell_id);
            column.most = std::max(column.most, keys[i].cell_id);
            column.ball = keys[i].ball_id;
        }
    }
    return column;
}

// The blocks that the pass sorts up and down.
void draw_blocks(const Scope& scope, const Plot& plot) {
    constexpr float narrowest = 3.0f;
    const float width = plot.width / static_cast<float>(scope.keys.size()) * static_cast<float>(scope.pass->k);
    if (width < narrowest) {
        return;
    }
    for (std::uint32_t slot = 0; slot < scope.keys.size(); slot += scope.pass->k) {
        const std::uint32_t block = slot / scope.pass->k;
        const float left = plot.low.x + width * static_cast<float>(block);
        const bool ascending = (slot & scope.pass->k) == 0;
        canvas().AddRectFilled(ImVec2(left, plot.low.y), ImVec2(left + width, plot.bottom()),
                               packed(Scope::direction_colour(ascending), 0.16f));
    }
}

void draw_keys(const Scope& scope, const Plot& plot) {
    const auto cells = static_cast<float>(std::max(scope.stepping.schedule->cell_count, 1u));
    const auto columns = std::max<std::size_t>(static_cast<std::size_t>(plot.width), 1);
    float padding = FLT_MAX;  // where a run of columns with nothing but padding begins
    const auto end_padding = [&](float x) {
        if (padding < x) {
            hatch(ImVec2(padding, plot.low.y), ImVec2(x, plot.bottom()));
        }
        padding = FLT_MAX;
    };
    for (std::size_t i = 0; i < columns; ++i) {
        const std::size_t first = i * scope.keys.size() / columns;
        const std::size_t last = std::max(first + 1, (i + 1) * scope.keys.size() / columns);
        const Column column = column_of(scope.keys.subspan(first, last - first));
        const float x = plot.low.x + static_cast<float>(i);
        if (column.least == SENTINEL) {
            padding = std::min(padding, x);
            continue;
        }
        end_padding(x);
        const float top = plot.low.y + plot.height * (1.0f - static_cast<float>(column.most + 1) / cells);
        const float bottom = plot.low.y + plot.height * (1.0f - static_cast<float>(column.least) / cells);
        canvas().AddRectFilled(ImVec2(x, top - 0.5f), ImVec2(x + 1.0f, std::max(bottom, top + 1.5f)),
                               packed(scope.state.which_colour(column.ball)));
    }
    end_padding(plot.right());
}

}  // namespace

void microscope_all(const Scope& scope) {
    const Plot plot{ImGui::GetCursorScreenPos(), scope.width, 7.0f * em()};
    canvas().AddRectFilled(plot.low, ImVec2(plot.right(), plot.bottom()), packed(cell_colour));
    if (scope.pass) {
        draw_blocks(scope, plot);
    }
    draw_keys(scope, plot);
    ImGui::InvisibleButton("all", ImVec2(plot.width, plot.height));
    if (ImGui::IsItemHovered()) {
        const float share = std::clamp((ImGui::GetIO().MousePos.x - plot.low.x) / plot.width, 0.0f, 1.0f);
        const auto slot = static_cast<std::size_t>(share * static_cast<float>(scope.keys.size()));
        hovered_slot(scope, static_cast<std::uint32_t>(std::min(slot, scope.keys.size() - 1)));
    }
    dim_text("Left to right: slots. Upwards: cell ids. Hatched: padding.");
}

}  // namespace ballpit::ui
