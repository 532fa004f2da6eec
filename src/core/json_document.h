// JSON text to a tree whose every value knows its file and place, so that whoever reads it can refuse a value in
// one sentence. Stricter than JSON: no key twice, no deep nesting.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/vector.h"

namespace ballpit {

/// Throws InputError with line and column (not UTF-8, not JSON, a number beyond double) or JSON pointer (a key
/// twice, nested deeper than 16).
nlohmann::json parse_json(std::string_view text, const std::string& file);

/// A value of the tree together with its place. Every reader throws InputError "<file>, <JSON pointer>: expected …,
/// found …".
class JsonValue {
public:
    using Pointer = nlohmann::json::json_pointer;

    JsonValue(const nlohmann::json& value, const std::string& file, Pointer pointer = Pointer())
        : value_(&value), file_(&file), pointer_(std::move(pointer)) {}

    /// This must be an object.
    void expect_object() const;
    /// This must be an object with no other keys than these.
    void expect_object(std::initializer_list<std::string_view> known_keys) const;
    std::vector<std::string> keys() const;
    JsonValue required(std::string_view key) const;
    std::optional<JsonValue> optional(std::string_view key) const;

    /// This must be an array; its elements one by one.
    std::size_t expect_array() const;
    JsonValue element(std::size_t index) const;

    std::string string() const;
    bool boolean() const;
    double number() const;
    double number_between(double minimum, double maximum, std::string_view unit) const;
    std::uint64_t whole_number(std::uint64_t maximum) const;
    /// An array of three numbers.
    dvec3 vector() const;
    dvec3 vector_between(double minimum, double maximum, std::string_view unit) const;

    [[noreturn]] void refuse(const std::string& expected) const;
    [[noreturn]] void refuse(const std::string& expected, const std::string& found) const;
    /// "<file>, <JSON pointer>"
    std::string place() const;

private:
    const nlohmann::json* value_;
    const std::string* file_;
    Pointer pointer_;
};

/// A number as a person would type it, and read back the same.
std::string shortest_text(double value);

}  // namespace ballpit
