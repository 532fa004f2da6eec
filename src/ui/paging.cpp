#include "ui/paging.h"

#include <algorithm>
#include <string>

#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

Pager::Pager(const char* name, std::uint64_t rows)
    : storage_(ImGui::GetStateStorage()),
      page_id_(ImGui::GetID(name)),
      serial_id_(ImGui::GetID((std::string(name) + " serial").c_str())),
      rows_(rows) {
    page_ = std::min<std::uint64_t>(static_cast<std::uint64_t>(storage_->GetInt(page_id_, 0)),
                                    std::max<std::uint64_t>(page_count(rows_), 1) - 1);
}

int Pager::rows_here() const { return static_cast<int>(std::min(rows_a_page, rows_ - std::min(rows_, first_row()))); }

void Pager::show_page(std::uint64_t page) {
    page_ = page;
    storage_->SetInt(page_id_, static_cast<int>(page));
}

void Pager::follow(const Jump& jump, std::optional<std::uint64_t> row) {
    if (static_cast<int>(jump.serial) == storage_->GetInt(serial_id_, 0) || !row || *row >= rows_) {
        return;
    }
    storage_->SetInt(serial_id_, static_cast<int>(jump.serial));
    show_page(page_of(*row));
    target_ = static_cast<int>(*row % rows_a_page);
}

void Pager::scroll(float row_height) {
    if (target_) {
        const float middle = 0.5f * ImGui::GetWindowHeight();
        ImGui::SetScrollY(std::max(0.0f, (static_cast<float>(*target_) + 1.5f) * row_height - middle));
    }
}

void Pager::draw() {
    const std::uint64_t pages = page_count(rows_);
    if (pages < 2) {
        return;
    }
    const auto turn = [this](const char* label, bool possible, std::uint64_t page) {
        ImGui::BeginDisabled(!possible);
        if (ImGui::Button(label)) {
            show_page(page);
        }
        ImGui::EndDisabled();
        ImGui::SameLine();
    };
    const std::uint64_t shown = page_;  // as the frame began: a pressed button does not change its neighbours
    turn("«", shown > 0, 0);
    turn("‹", shown > 0, shown - 1);
    turn("›", shown + 1 < pages, shown + 1);
    turn("»", shown + 1 < pages, pages - 1);
    dim_text("rows " + range_text(shown * rows_a_page, std::min(rows_, (shown + 1) * rows_a_page)) + " of " +
             grouped(rows_));
}

std::optional<std::uint32_t> number_field(const char* label, const char* about, std::optional<std::uint32_t> chosen) {
    ImGui::PushID(label);
    ImGui::AlignTextToFramePadding();
    text(label);
    tooltip(about);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(4.6f * em());
    ImGuiStorage* storage = ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID("value");
    const ImGuiID chosen_id = ImGui::GetID("chosen");
    if (chosen && static_cast<std::uint32_t>(storage->GetInt(chosen_id, -1)) != *chosen) {
        storage->SetInt(chosen_id, static_cast<int>(*chosen));
        storage->SetInt(id, static_cast<int>(*chosen));
    }
    auto value = static_cast<std::uint32_t>(storage->GetInt(id, 0));
    const bool entered = ImGui::InputScalar("##number", ImGuiDataType_U32, &value, nullptr, nullptr, "%u",
                                            ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    tooltip(about);
    ImGui::PopID();
    if (!entered) {
        return std::nullopt;
    }
    storage->SetInt(id, static_cast<int>(value));
    return value;
}

}  // namespace ballpit::ui
