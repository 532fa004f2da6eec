// JSON text to a tree: what is no UTF-8, no JSON, nested too deeply or has a key twice is refused with its place.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/json_document.h"
#include "core/json_words.h"

namespace ballpit {

using nlohmann::json;

namespace {

constexpr std::size_t deepest_nesting = 16;
constexpr std::size_t longest_complaint = 160;

std::string place_in_text(std::string_view text, std::size_t offset, const std::string& file) {
    const std::string_view before = text.substr(0, offset);
    const auto line = 1 + std::ranges::count(before, '\n');
    const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
    // Columns count characters, not the continuation bytes of UTF-8.
    const auto column = 1 + std::ranges::count_if(before.substr(line_start), [](char c) { return (c & 0xC0) != 0x80; });
    return file + ", line " + std::to_string(line) + ", column " + std::to_string(column);
}

// Bytes of the UTF-8 sequence at the start of `text`; 0 if it is none (RFC 3629: no overlong forms, no surrogates).
std::size_t utf8_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const unsigned lead = byte(0);
    if (lead < 0x80) {
        return 1;
    }
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    const unsigned low = lead == 0xE0 ? 0xA0 : lead == 0xF0 ? 0x90 : 0x80;
    const unsigned high = lead == 0xED ? 0x9F : lead == 0xF4 ? 0x8F : 0xBF;
    if (lead < 0xC2 || lead > 0xF4 || byte(1) < low || byte(1) > high) {
        return 0;
    }
    for (std::size_t i = 2; i < length; ++i) {
        if ((byte(i) & 0xC0) != 0x80) {
            return 0;
        }
    }
    return length;
}

void expect_utf8(std::string_view text, const std::string& file) {
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = utf8_length(text.substr(at));
        if (length == 0) {
            throw InputError(place_in_text(text, at, file) + ": expected UTF-8 text, found a byte that is not");
        }
        at += length;
    }
}

// The library's own words without its error number and its place, which we give in our own form.
std::string syntax_complaint(const std::string& what) {
    std::size_t start = what.find("] ");
    start = start == std::string::npos ? 0 : start + 2;
    if (const std::size_t details = what.find(" - ", start); details != std::string::npos) {
        start = details + 3;
    } else if (const std::size_t number = what.find("number overflow", start); number != std::string::npos) {
        start = number;
    }
    return readable(what.substr(start, what.find("; last read", start) - start), longest_complaint);
}

// Builds the tree itself, because the library's own builder keeps the last of equal keys in silence.
class TreeBuilder : public nlohmann::json_sax<json> {
public:
    TreeBuilder(std::string_view text, const std::string& file, const StreamedList& list)
        : text_(text), file_(file), list_(list) {}

    json take() { return std::move(root_); }

    bool null() override { return add_leaf(json()); }
    bool boolean(bool value) override { return add_leaf(json(value)); }
    // The only zero that comes here is written "-0"; an integer would lose its sign.
    bool number_integer(number_integer_t value) override { return add_leaf(value == 0 ? json(-0.0) : json(value)); }
    bool number_unsigned(number_unsigned_t value) override { return add_leaf(json(value)); }
    bool number_float(number_float_t value, const string_t&) override { return add_leaf(json(value)); }
    bool string(string_t& value) override { return add_leaf(json(std::move(value))); }
    bool binary(binary_t& value) override { return add_leaf(json(std::move(value))); }
    bool start_object(std::size_t) override { return open(json::object()); }
    bool start_array(std::size_t) override { return open(json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& name) override {
        if (open_.back()->contains(name)) {
            pointer_.push_back(name);
            throw InputError(place_in_tree(file_, pointer_) + ": expected every key once, found this one twice");
        }
        key_ = std::move(name);
        return true;
    }

    bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& error) override {
        // The position is one past the last byte read, which is the culprit (or the end of the text).
        const std::size_t offset = std::min(position == 0 ? 0 : position - 1, text_.size());
        // The library's words for an empty text differ from version to version.
        const std::string found = text_.empty() ? "an empty file" : syntax_complaint(error.what());
        throw InputError(place_in_text(text_, offset, file_) + ": expected JSON, found " + found);
    }

private:
    json* add(json value) {
        if (open_.empty()) {
            root_ = std::move(value);
            return &root_;
        }
        json& parent = *open_.back();
        if (parent.is_array()) {
            parent.push_back(std::move(value));
            return &parent.back();
        }
        return &(parent[key_] = std::move(value));
    }

    bool add_leaf(json value) {
        add(std::move(value));
        completed();
        return true;
    }

    // Hands on what has just been read whole, if it is an element of the streamed list.
    void completed() {
        if (open_.size() == 2 && open_.back() == streamed_) {
            const JsonValue root(root_, file_);
            const JsonValue list(*streamed_, root, list_.key);
            list_.take(JsonValue(streamed_->back(), list, taken_));
            streamed_->clear();
            ++taken_;
        }
    }

    bool open(json container) {
        json* opened = add(std::move(container));
        if (!open_.empty()) {
            // An element's number is known only now that it is added.
            json& parent = *open_.back();
            const std::size_t before = &parent == streamed_ ? taken_ : parent.size() - 1;
            parent.is_array() ? pointer_.push_back(std::to_string(before)) : pointer_.push_back(key_);
        }
        if (list_.take && open_.size() == 1 && opened->is_array() && pointer_.back() == list_.key) {
            streamed_ = opened;
        }
        open_.push_back(opened);
        if (open_.size() > deepest_nesting) {
            throw InputError(place_in_tree(file_, pointer_) + ": expected at most " + std::to_string(deepest_nesting) +
                             " levels of nesting, found more");
        }
        return true;
    }

    bool close() {
        open_.pop_back();
        if (!pointer_.empty()) {
            pointer_.pop_back();
        }
        completed();
        return true;
    }

    std::string_view text_;
    const std::string& file_;
    const StreamedList& list_;
    json* streamed_ = nullptr;  // the streamed list, from its beginning on
    std::size_t taken_ = 0;     // its elements that were handed on
    json root_;
    std::vector<json*> open_;
    json::json_pointer pointer_;
    std::string key_;
};

}  // namespace

json parse_json(std::string_view text, const std::string& file, const StreamedList& list) {
    expect_utf8(text, file);
    TreeBuilder builder(text, file, list);
    json::sax_parse(text.begin(), text.end(), &builder);
    return builder.take();
}

}  // namespace ballpit
