// Tables longer than a scroll bar can resolve: pages of rows, and a field to type a number to look for.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <optional>

#include "ui/probe.h"

namespace ballpit::ui {

/// The page that a table shows, kept by ImGui under the id of the window that is open.
class Pager {
public:
    Pager(const char* name, std::uint64_t rows);

    std::uint64_t first_row() const { return page_ * rows_a_page; }
    int rows_here() const;

    /// Turns to the row of a wish that was not yet granted, and says where in the page it stands.
    void follow(const Jump& jump, std::optional<std::uint64_t> row);
    /// Inside the table: brings the row of that wish into sight; `row_height` in pixels.
    void scroll(float row_height);

    /// Buttons and "rows 1…10 000 of 40 960"; nothing for a single page.
    void draw();

private:
    void show_page(std::uint64_t page);

    ImGuiStorage* storage_;
    ImGuiID page_id_;
    ImGuiID serial_id_;
    std::uint64_t rows_;
    std::uint64_t page_ = 0;
    std::optional<int> target_;  // row in the page
};

/// "Ball [  73]": the number when Enter was pressed. What was typed stays there, until something else is `chosen`.
std::optional<std::uint32_t> number_field(const char* label, const char* about,
                                          std::optional<std::uint32_t> chosen = std::nullopt);

}  // namespace ballpit::ui
