#include "core/text.h"

#include <array>
#include <charconv>

namespace ballpit {

namespace {

template <class Word>
std::string join(std::span<const Word> words) {
    std::string text;
    for (const Word& word : words) {
        text.append(text.empty() ? "" : ", ").append(word);
    }
    return text;
}

}  // namespace

std::string shortest_text(double value) {
    std::array<char, 32> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), result.ptr};
}

std::string joined(std::span<const std::string> words) { return join(words); }
std::string joined(std::span<const std::string_view> words) { return join(words); }

std::string range_text(double minimum, double maximum, std::string_view unit, std::string_view kind) {
    return std::string(kind) + " from " + shortest_text(minimum) + " to " + shortest_text(maximum) +
           (unit.empty() ? "" : " " + std::string(unit));
}

}  // namespace ballpit
