// JSON text to a tree whose every value knows its file and place, so that whoever reads it can refuse a value in
// one sentence. Stricter than JSON: no key twice, no deep nesting.
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/text.h"
#include "core/vector.h"

namespace ballpit {

/// A value of the tree together with its place, which is put into words only when it is needed: a value must not
/// outlive the one that it was taken from. Every reader throws InputError "<file>, <JSON pointer>: expected …, found
/// …".
class JsonValue {
public:
    /// The outermost value of a file.
    JsonValue(const nlohmann::json& value, const std::string& file) : value_(&value), file_(&file) {}
    /// A member of an object; the key must live as long.
    JsonValue(const nlohmann::json& value, const JsonValue& parent, std::string_view key)
        : value_(&value), file_(parent.file_), parent_(&parent), key_(key) {}
    /// An element of an array.
    JsonValue(const nlohmann::json& value, const JsonValue& parent, std::size_t index)
        : value_(&value), file_(parent.file_), parent_(&parent), index_(index) {}

    /// This must be an object.
    void expect_object() const;
    /// This must be an object with no other keys than these.
    void expect_object(std::initializer_list<std::string_view> known_keys) const;
    std::vector<std::string> keys() const;
    JsonValue required(std::string_view key) const;
    std::optional<JsonValue> optional(std::string_view key) const;

    bool is_object() const { return value_->is_object(); }
    bool is_string() const { return value_->is_string(); }
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
    nlohmann::json::json_pointer pointer() const;

    const nlohmann::json* value_;
    const std::string* file_;
    const JsonValue* parent_ = nullptr;
    std::string_view key_;  // empty for elements of an array
    std::size_t index_ = 0;
};

/// The list that is the value of `key` in the outermost object, if there is one: `take` gets its elements one by one,
/// and the tree keeps an empty list. Millions of elements then need no more memory than one.
struct StreamedList {
    std::string_view key;
    std::function<void(const JsonValue&)> take;  // none: nothing is streamed
};

/// Throws InputError with line and column (not UTF-8, not JSON, a number beyond double) or JSON pointer (a key
/// twice, nested deeper than 16).
nlohmann::json parse_json(std::string_view text, const std::string& file, const StreamedList& list = {});

}  // namespace ballpit
