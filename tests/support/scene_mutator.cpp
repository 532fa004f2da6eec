#include "support/scene_mutator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <string_view>

#include "support/dice.h"

namespace ballpit::test {

using nlohmann::json;

namespace {

// What parsers stumble over.
constexpr std::array<std::string_view, 34> tokens = {"{",
                                                     "}",
                                                     "[",
                                                     "]",
                                                     "\"",
                                                     ":",
                                                     ",",
                                                     "null",
                                                     "true",
                                                     "NaN",
                                                     "-Infinity",
                                                     "-",
                                                     "-0",
                                                     "0.0",
                                                     "1e999",
                                                     "1e-999",
                                                     "1e308",
                                                     "-1e30",
                                                     "4294967296",
                                                     "4194305",
                                                     "2147483648",
                                                     "\\u0000",
                                                     "\\ud800",
                                                     "\xEF\xBB\xBF",
                                                     "\xC3",
                                                     "\xF4\x90\x80\x80",
                                                     "\n",
                                                     "\x01",
                                                     "/*",
                                                     "//",
                                                     "18446744073709551616",
                                                     "-9223372036854775809",
                                                     "[[[[[[[[[[[[[[[[[[[[",
                                                     R"({"a":{"a":{"a":{"a":{"a":)"};

constexpr std::array<double, 24> numbers = {0.0,  -0.0,    1.0,  -1.0,  0.5,    2.0,    1e-3,  9.99e-4,
                                            1e4,  10000.1, 1e6,  -1e6,  1e8,    1e30,   -1e30, 1e308,
                                            1e-9, 5e-324,  0.05, 100.0, 1024.0, 1025.0, 0.25,  8.0};

const std::array<json, 9>& values() {
    static const std::array<json, 9> list = {
        json(),         json(true),       json(false),
        json(""),       json("leapfrog"), json::array(),
        json::object(), json(4194304u),   json(std::numeric_limits<std::uint64_t>::max())};
    return list;
}

void collect(json& node, std::vector<json*>& found) {
    found.push_back(&node);
    if (node.is_structured()) {
        for (json& inner : node) {
            collect(inner, found);
        }
    }
}

json& random_node(json& tree, Dice& dice) {
    std::vector<json*> nodes;
    collect(tree, nodes);
    return *dice.one_of(nodes);
}

// A key that some scene has somewhere, so that it stands where it is nearly right.
std::string random_key(const json& tree, Dice& dice) {
    const json* node = &tree;
    std::string key = "name";
    while (node->is_structured() && !node->empty()) {
        auto inner = node->begin();
        std::advance(inner, static_cast<std::ptrdiff_t>(dice.below(node->size())));
        if (node->is_object()) {
            key = inner.key();
        }
        node = &*inner;
        if (node->is_structured() && dice.unit() < 0.3) {
            break;
        }
    }
    return key;
}

void change_object(json& object, const json& other, Dice& dice) {
    if (object.empty() || dice.unit() < 0.2) {
        object[random_key(other, dice)] = json(dice.one_of(numbers));
        return;
    }
    auto member = object.begin();
    std::advance(member, static_cast<std::ptrdiff_t>(dice.below(object.size())));
    json value = *member;
    object.erase(member);
    if (dice.unit() < 0.3) {
        object[random_key(other, dice)] = std::move(value);
    }
}

void change_list(json& list, Dice& dice) {
    if (list.empty()) {
        return;
    }
    const auto at = list.begin() + static_cast<std::ptrdiff_t>(dice.below(list.size()));
    if (dice.unit() < 0.5) {
        const json copy = *at;
        list.push_back(copy);
    } else {
        list.erase(at);
    }
}

void change_number(json& number, Dice& dice) {
    if (dice.unit() < 0.3) {
        number = dice.one_of(numbers);
    } else if (number.is_number_unsigned()) {
        number = static_cast<std::uint64_t>(number.get<double>() * 0.999 * dice.unit()) + dice.below(2);
    } else {
        number = number.get<double>() * std::exp2(4.0 * dice.unit() - 2.0);
    }
}

void change_tree(json& tree, const json& other, Dice& dice) {
    json& node = random_node(tree, dice);
    const double what = dice.unit();
    if (what < 0.1) {
        node = dice.one_of(values());
    } else if (what < 0.2) {
        json copy = other;
        const json part = random_node(copy, dice);
        node = part;
    } else if (what < 0.25) {
        node = json::array({node});
    } else if (node.is_object()) {
        change_object(node, other, dice);
    } else if (node.is_array()) {
        change_list(node, dice);
    } else if (node.is_number()) {
        change_number(node, dice);
    }
}

void change_text(std::string& text, const std::string& other, Dice& dice) {
    const std::size_t at = dice.below(text.size() + 1);
    const std::size_t length = dice.below(dice.unit() < 0.8 ? 16 : 1024);
    switch (dice.below(6)) {
        case 0:
            if (at < text.size()) {
                text[at] = static_cast<char>(text[at] ^ (1 << dice.below(8)));
            }
            return;
        case 1:
            text.insert(at, dice.one_of(tokens));
            return;
        case 2:
            text.erase(at, length);
            return;
        case 3:
            text.insert(at, text.substr(at, length));
            return;
        case 4:
            text.replace(at, std::min(length, text.size() - at), other, dice.below(other.size()), length);
            return;
        default:
            text.insert(at, 1, static_cast<char>(dice.below(256)));
    }
}

std::string read(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

SceneMutator::SceneMutator(const std::vector<std::filesystem::path>& folders) {
    std::vector<std::filesystem::path> files;
    for (const auto& folder : folders) {
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            if (entry.path().extension() == ".json" && entry.path().stem().extension() != ".schema") {
                files.push_back(entry.path());
            }
        }
    }
    std::ranges::sort(files, {}, &std::filesystem::path::filename);
    for (const auto& path : files) {
        texts_.push_back(read(path));
        trees_.push_back(json::parse(texts_.back(), nullptr, false));
    }
}

std::string SceneMutator::text(std::uint64_t seed, std::uint64_t number) const {
    Dice dice(seed, number);
    const std::size_t start = dice.below(texts_.size());
    std::string text = texts_[start];
    const bool is_tree = !trees_[start].is_discarded();
    if (is_tree && dice.unit() < 0.7) {
        json tree = trees_[start];
        for (std::size_t changes = dice.below(5); changes > 0; --changes) {
            const json& other = dice.one_of(trees_);
            change_tree(tree, other.is_discarded() ? trees_[start] : other, dice);
        }
        text = tree.dump(-1, ' ', false, json::error_handler_t::replace);
    }
    if (!is_tree || dice.unit() < 0.5) {
        for (std::size_t changes = dice.below(5); changes > 0; --changes) {
            change_text(text, dice.one_of(texts_), dice);
        }
    }
    return text;
}

}  // namespace ballpit::test
