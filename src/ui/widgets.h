// Small controls that several panels share.
#pragma once

#include <string>
#include <string_view>

namespace ballpit::ui {

void text(std::string_view words);
void dim_text(std::string_view words);
/// Wraps at the right edge of the window.
void wrapped_text(std::string_view words);
void wrapped_dim_text(std::string_view words);

/// A button with its key printed inside, dimmer, at the right. `width` in pixels. Accent: the one to look at first.
bool key_button(const char* label, std::string_view keys, float width, bool accent = false);

/// A check box with its key printed beside it; `keys` may be empty. True when it was changed.
bool key_checkbox(const char* label, bool& value, std::string_view keys);

/// Width that `columns` equal controls in a row have.
float column_width(int columns);

/// A heading that folds what follows; open at first if `open`.
bool section(const char* title, bool open);

/// A label at the left, in the column that every row of the side panel shares; the next item fills the rest less
/// `right` pixels. `about` shows while the pointer rests on the label.
void row_label(std::string_view label, std::string_view about, float right = 0.0f);

/// What computes, as a user knows it; by the backend's name.
std::string_view computer_text(std::string_view backend_name);

/// Shown while the pointer rests on the item before.
void tooltip(std::string_view words);

/// 1234567 as "1 234 567" (thin spaces).
std::string grouped(unsigned long long number);

/// printf into a string.
std::string format(const char* pattern, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 1, 2)))
#endif
    ;

}  // namespace ballpit::ui
