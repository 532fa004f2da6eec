// A plot with logarithmic axes in the window that is being drawn.
#pragma once

#include <string_view>

#include "ui/explorer.h"
#include "ui/style.h"

namespace ballpit::ui {

class LogPlot {
public:
    /// Takes the room at the cursor, `size` pixels with its labels; draws frame, decades and labels. The y axis is
    /// logarithmic, x as well unless it is linear.
    struct Axes {
        Decades x;  // exponents of ten; for a linear axis the values at its ends
        Decades y;
        bool linear_x = false;
        std::string_view x_label;
        std::string_view y_label;
    };
    LogPlot(const char* id, ImVec2 size, const Axes& axes);

    /// Where a value stands; what lies outside is held at the edge.
    ImVec2 place(double x, double y) const;
    /// Whether the pointer is over the plot, and nothing lies on it.
    bool hovered() const { return hovered_; }
    bool clicked() const { return clicked_; }

    void horizontal(double y, ImU32 colour, std::string_view label) const;
    /// Everything to the right of x.
    void shade_from(double x, ImU32 colour) const;
    ImDrawList* list() const { return list_; }

private:
    float across(double x) const;
    float up(double y) const;
    void draw_axis_x(std::string_view label) const;
    void draw_axis_y(std::string_view label) const;

    Axes axes_;
    ImDrawList* list_;
    ImVec2 low_;   // upper left corner of the frame
    ImVec2 high_;  // lower right
    bool hovered_ = false;
    bool clicked_ = false;
};

/// Leapfrog a disc, symplectic Euler a square, velocity Verlet a triangle, forward Euler a diamond, historical a cross;
/// hollow where sums are compensated.
void draw_symbol(ImDrawList* list, ImVec2 centre, float radius, const measure::SweepPoint& point);

}  // namespace ballpit::ui
