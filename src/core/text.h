// Numbers and lists as text.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace ballpit {

/// A number as a person would type it, and read back the same.
std::string shortest_text(double value);

/// "a, b, c".
std::string joined(std::span<const std::string> words);
std::string joined(std::span<const std::string_view> words);

/// "a number from 0 to 1 m", or of another kind; without a unit nothing after it.
std::string range_text(double minimum, double maximum, std::string_view unit, std::string_view kind = "a number");

}  // namespace ballpit
