// How messages about a JSON file repeat what stands in it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace ballpit {

inline constexpr std::size_t longest_quote = 60;  // bytes of the file's own text that a message repeats

/// The file's own text on one line, without control characters, and cut between characters after `longest` bytes.
std::string readable(std::string_view text, std::size_t longest = longest_quote);

/// "<file>, <JSON pointer>".
std::string place_in_tree(const std::string& file, const nlohmann::json::json_pointer& pointer);

}  // namespace ballpit
