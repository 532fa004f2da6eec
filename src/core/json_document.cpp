#include "core/json_document.h"

#include <algorithm>

#include "core/error.h"
#include "core/json_words.h"

namespace ballpit {

using nlohmann::json;

namespace {

constexpr std::size_t longest_place = 120;
constexpr std::string_view hexadecimal = "0123456789ABCDEF";

std::string found_text(const json& value) {
    if (value.is_object()) {
        return "an object";
    }
    if (value.is_array()) {
        return "a list of " + std::to_string(value.size());
    }
    return readable(value.dump());
}

}  // namespace

std::string readable(std::string_view text, std::size_t longest) {
    std::size_t end = std::min(text.size(), longest);
    while (end < text.size() && end > 0 && (text[end] & 0xC0) == 0x80) {
        --end;
    }
    std::string line;
    for (const char c : text.substr(0, end)) {
        const auto code = static_cast<unsigned char>(c);
        const bool control = code < 0x20 || code == 0x7F;
        line += control ? "\\x" + std::string{hexadecimal[code / 16], hexadecimal[code % 16]} : std::string{c};
    }
    return end < text.size() ? line + "…" : line;
}

std::string place_in_tree(const std::string& file, const json::json_pointer& pointer) {
    return pointer.empty() ? file : file + ", " + readable(pointer.to_string(), longest_place);
}

json::json_pointer JsonValue::pointer() const {
    if (parent_ == nullptr) {
        return json::json_pointer();
    }
    return key_.empty() ? parent_->pointer() / index_ : parent_->pointer() / std::string(key_);
}

std::string JsonValue::place() const { return place_in_tree(*file_, pointer()); }

void JsonValue::refuse(const std::string& expected) const { refuse(expected, found_text(*value_)); }

void JsonValue::refuse(const std::string& expected, const std::string& found) const {
    throw InputError(place() + ": expected " + expected + ", found " + found);
}

void JsonValue::expect_object() const {
    if (!value_->is_object()) {
        refuse("an object");
    }
}

void JsonValue::expect_object(std::initializer_list<std::string_view> known_keys) const {
    expect_object();
    for (const auto& item : value_->items()) {
        if (std::ranges::find(known_keys, std::string_view(item.key())) == known_keys.end()) {
            std::string list;
            for (const std::string_view known : known_keys) {
                list += (list.empty() ? "" : ", ") + std::string(known);
            }
            refuse("no other keys than " + list, "'" + readable(item.key()) + "'");
        }
    }
}

std::vector<std::string> JsonValue::keys() const {
    std::vector<std::string> keys;
    for (const auto& item : value_->items()) {
        keys.push_back(item.key());
    }
    return keys;
}

JsonValue JsonValue::required(std::string_view key) const {
    const auto member = optional(key);
    if (!member) {
        refuse("a key '" + std::string(key) + "'", "none");
    }
    return *member;
}

std::optional<JsonValue> JsonValue::optional(std::string_view key) const {
    const auto found = value_->find(std::string(key));
    if (found == value_->end()) {
        return std::nullopt;
    }
    return JsonValue(*found, *this, key);
}

std::size_t JsonValue::expect_array() const {
    if (!value_->is_array()) {
        refuse("a list");
    }
    return value_->size();
}

JsonValue JsonValue::element(std::size_t index) const { return {value_->at(index), *this, index}; }

std::string JsonValue::string() const {
    if (!value_->is_string()) {
        refuse("text");
    }
    return value_->get<std::string>();
}

bool JsonValue::boolean() const {
    if (!value_->is_boolean()) {
        refuse("true or false");
    }
    return value_->get<bool>();
}

double JsonValue::number() const {
    if (!value_->is_number()) {
        refuse("a number");
    }
    return value_->get<double>();
}

double JsonValue::number_between(double minimum, double maximum, std::string_view unit) const {
    const double value = number();
    if (!(value >= minimum && value <= maximum)) {
        refuse(range_text(minimum, maximum, unit));
    }
    return value;
}

std::uint64_t JsonValue::whole_number(std::uint64_t maximum) const {
    if (!value_->is_number_unsigned() || value_->get<std::uint64_t>() > maximum) {
        refuse("a whole number from 0 to " + std::to_string(maximum));
    }
    return value_->get<std::uint64_t>();
}

dvec3 JsonValue::vector() const {
    if (!value_->is_array() || value_->size() != 3) {
        refuse("a list of three numbers");
    }
    return {element(0).number(), element(1).number(), element(2).number()};
}

dvec3 JsonValue::vector_between(double minimum, double maximum, std::string_view unit) const {
    const dvec3 value = vector();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        element(axis).number_between(minimum, maximum, unit);
    }
    return value;
}

}  // namespace ballpit
