#include "ui/log_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

const ImU32 ink = packed(text_colour);
const ImU32 dim_ink = packed(dim_colour);
const ImU32 paper = packed(vec3(0.10f, 0.12f, 0.14f));
const ImU32 grid_line = packed(vec3(0.22f, 0.26f, 0.30f));

// Okabe and Ito's colours, one an integrator; the shapes say the same.
const std::array<ImU32, 5> integrator_colours = {packed(vec3(0.34f, 0.71f, 0.91f)), packed(vec3(0.00f, 0.62f, 0.45f)),
                                                 packed(vec3(0.94f, 0.89f, 0.26f)), packed(vec3(0.80f, 0.47f, 0.65f)),
                                                 packed(vec3(0.84f, 0.37f, 0.00f))};

std::string decade_text(int exponent) {
    return exponent >= -2 && exponent <= 3 ? format("%g", std::pow(10.0, exponent)) : format("1e%d", exponent);
}

// Not more than about one decade in `room` pixels has its number.
int decades_a_label(double decades, float room, float wanted) {
    return std::max(1, static_cast<int>(std::ceil(decades * static_cast<double>(wanted) / static_cast<double>(room))));
}

}  // namespace

LogPlot::LogPlot(const char* id, ImVec2 size, const Axes& axes) : axes_(axes), list_(ImGui::GetWindowDrawList()) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    low_ = ImVec2(corner.x + 3.6f * em(), corner.y + 1.4f * em());
    high_ = ImVec2(corner.x + size.x - 0.6f * em(), corner.y + size.y - 2.6f * em());
    ImGui::InvisibleButton(id, size);
    hovered_ = ImGui::IsItemHovered();
    clicked_ = ImGui::IsItemClicked();
    list_->AddRectFilled(low_, high_, paper);
    draw_axis_x(axes_.x_label);
    draw_axis_y(axes_.y_label);
    list_->AddRect(low_, high_, dim_ink);
}

float LogPlot::across(double x) const {
    const double at = axes_.linear_x ? x : std::log10(std::max(x, 1e-300));
    const double share = (at - axes_.x.low) / (axes_.x.high - axes_.x.low);
    return low_.x + static_cast<float>(std::clamp(share, 0.0, 1.0)) * (high_.x - low_.x);
}

float LogPlot::up(double y) const {
    const double share = (std::log10(std::max(y, 1e-300)) - axes_.y.low) / (axes_.y.high - axes_.y.low);
    return high_.y - static_cast<float>(std::clamp(share, 0.0, 1.0)) * (high_.y - low_.y);
}

ImVec2 LogPlot::place(double x, double y) const { return {across(x), up(y)}; }

void LogPlot::draw_axis_x(std::string_view label) const {
    const float below = high_.y + 0.2f * em();
    if (axes_.linear_x) {
        for (int i = 0; i <= 4; ++i) {
            const double value = axes_.x.low + (axes_.x.high - axes_.x.low) * i / 4.0;
            const std::string words = format("%.3g", value);
            list_->AddText(ImVec2(across(value) - 0.5f * ImGui::CalcTextSize(words.c_str()).x, below), dim_ink,
                           words.c_str());
        }
    } else {
        const int every = decades_a_label(axes_.x.high - axes_.x.low, high_.x - low_.x, 4.0f * em());
        for (int e = static_cast<int>(axes_.x.low); e <= static_cast<int>(axes_.x.high); ++e) {
            const float x = across(std::pow(10.0, e));
            list_->AddLine(ImVec2(x, low_.y), ImVec2(x, high_.y), grid_line);
            if ((e - static_cast<int>(axes_.x.low)) % every == 0) {
                const std::string words = decade_text(e);
                list_->AddText(ImVec2(x - 0.5f * ImGui::CalcTextSize(words.c_str()).x, below), dim_ink, words.c_str());
            }
        }
    }
    const std::string words(label);
    const float middle = 0.5f * (low_.x + high_.x - ImGui::CalcTextSize(words.c_str()).x);
    list_->AddText(ImVec2(middle, below + 1.1f * em()), ink, words.c_str());
}

void LogPlot::draw_axis_y(std::string_view label) const {
    const int every = decades_a_label(axes_.y.high - axes_.y.low, high_.y - low_.y, 1.6f * em());
    for (int e = static_cast<int>(axes_.y.low); e <= static_cast<int>(axes_.y.high); ++e) {
        const float y = up(std::pow(10.0, e));
        list_->AddLine(ImVec2(low_.x, y), ImVec2(high_.x, y), grid_line);
        if ((e - static_cast<int>(axes_.y.low)) % every == 0) {
            const std::string words = decade_text(e);
            list_->AddText(ImVec2(low_.x - 0.3f * em() - ImGui::CalcTextSize(words.c_str()).x, y - 0.5f * em()),
                           dim_ink, words.c_str());
        }
    }
    list_->AddText(ImVec2(low_.x, low_.y - 1.3f * em()), ink, std::string(label).c_str());
}

void LogPlot::horizontal(double y, ImU32 colour, std::string_view label) const {
    const float at = up(y);
    const float dash = 0.4f * em();
    for (float x = low_.x; x < high_.x; x += 2.0f * dash) {
        list_->AddLine(ImVec2(x, at), ImVec2(std::min(x + dash, high_.x), at), colour, 1.5f);
    }
    const std::string words(label);
    const float width = ImGui::CalcTextSize(words.c_str()).x;
    list_->AddText(ImVec2(high_.x - width - 0.3f * em(), at - 1.1f * em()), colour, words.c_str());
}

void LogPlot::shade_from(double x, ImU32 colour) const {
    list_->AddRectFilled(ImVec2(across(x), low_.y), high_, colour);
}

void draw_symbol(ImDrawList* list, ImVec2 c, float r, const measure::SweepPoint& point) {
    const ImU32 colour = integrator_colours.at(static_cast<std::size_t>(point.integrator));
    const float line = std::max(1.5f, 0.3f * r);
    if (point.integrator == Integrator::historical) {
        list->AddLine(ImVec2(c.x - r, c.y - r), ImVec2(c.x + r, c.y + r), colour, line);
        list->AddLine(ImVec2(c.x - r, c.y + r), ImVec2(c.x + r, c.y - r), colour, line);
    } else {
        // Regular polygons: many corners make the disc.
        struct Shape {
            int corners;
            float turn;  // rad of the first corner
        };
        constexpr float quarter = 0.785398f;
        constexpr std::array<Shape, 4> shapes = {{{16, 0.0f}, {4, quarter}, {3, -2.0f * quarter}, {4, 0.0f}}};
        const Shape& shape = shapes.at(static_cast<std::size_t>(point.integrator));
        std::array<ImVec2, 16> corners{};
        for (int i = 0; i < shape.corners; ++i) {
            const float angle = shape.turn + 8.0f * quarter * static_cast<float>(i) / static_cast<float>(shape.corners);
            corners.at(static_cast<std::size_t>(i)) = ImVec2(c.x + r * std::cos(angle), c.y + r * std::sin(angle));
        }
        if (point.compensated) {
            list->AddPolyline(corners.data(), shape.corners, colour, ImDrawFlags_Closed, line);
        } else {
            list->AddConvexPolyFilled(corners.data(), shape.corners, colour);
        }
    }
    if (point.grid_reuse > 1) {
        list->AddCircleFilled(c, 0.35f * r, packed(vec3(0.0f)));
    }
}

}  // namespace ballpit::ui
