#include "measure/comparison.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include "core/backend.h"

namespace ballpit::measure {

namespace {

// How the elements of a slot are made up, and what they are called.
struct Form {
    std::size_t words;  // 32-bit words an element
    bool floats;
    std::string_view element;
};

constexpr std::array<Form, slot_count> forms = {{{4, true, "ball"},
                                                 {4, true, "ball"},
                                                 {1, true, "ball"},
                                                 {2, false, "slot"},
                                                 {2, false, "cell"},
                                                 {4, false, "status"},
                                                 {4, true, "ball"},
                                                 {4, true, "ball"}}};

constexpr std::size_t places_kept = 1000;

std::string word_text(std::uint32_t word, bool is_float) {
    if (!is_float) {
        return std::to_string(word);
    }
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), std::bit_cast<float>(word)).ptr;
    return {text.data(), end};
}

std::string element_text(const std::uint32_t* words, const Form& form) {
    std::string text = "(";
    for (std::size_t i = 0; i < form.words; ++i) {
        text += (i == 0 ? "" : ", ") + word_text(words[i], form.floats);
    }
    return text + ")";
}

// Largest distance of the floats of an element; infinite where one of them is no number.
double distance(const std::uint32_t* a, const std::uint32_t* b, std::size_t words) {
    double largest = 0.0;
    for (std::size_t i = 0; i < words; ++i) {
        if (a[i] == b[i]) {
            continue;
        }
        const double d =
            std::abs(static_cast<double>(std::bit_cast<float>(a[i])) - static_cast<double>(std::bit_cast<float>(b[i])));
        largest = std::isnan(d) ? INFINITY : std::max(largest, d);
    }
    return largest;
}

}  // namespace

std::uint64_t ulp_distance(float a, float b) {
    const auto bits_a = std::bit_cast<std::uint32_t>(a);
    const auto bits_b = std::bit_cast<std::uint32_t>(b);
    if (bits_a == bits_b) {
        return 0;
    }
    if (std::isnan(a) || std::isnan(b)) {
        return UINT64_MAX;
    }
    // Sign and magnitude to a number line on which neighbours are 1 apart and both zeros meet.
    const auto line = [](std::uint32_t bits) {
        const auto magnitude = static_cast<std::int64_t>(bits & 0x7FFFFFFFu);
        return (bits >> 31) != 0 ? -magnitude : magnitude;
    };
    return static_cast<std::uint64_t>(std::abs(line(bits_a) - line(bits_b)));
}

std::size_t element_count(Slot slot, std::span<const std::byte> bytes) {
    return bytes.size() / (forms[static_cast<std::size_t>(slot)].words * sizeof(std::uint32_t));
}

Comparison compare_slot(Slot slot, std::span<const std::byte> gpu, std::span<const std::byte> cpu,
                        std::span<const double> bounds) {
    const Form& form = forms[static_cast<std::size_t>(slot)];
    const auto a = typed<std::uint32_t>(gpu);
    const auto b = typed<std::uint32_t>(cpu);
    const std::size_t common = std::min(a.size(), b.size()) / form.words;
    Comparison result;
    result.elements = std::max(a.size(), b.size()) / form.words;
    result.differing = result.beyond_bound = result.elements - common;
    if (result.elements != common) {
        result.first = "GPU has " + std::to_string(a.size() / form.words) + " elements, CPU " +
                       std::to_string(b.size() / form.words);
    }
    bool first_is_beyond = result.beyond_bound != 0;
    for (std::size_t i = 0; i < common; ++i) {
        const std::uint32_t* in_a = &a[i * form.words];
        const std::uint32_t* in_b = &b[i * form.words];
        if (std::equal(in_a, in_a + form.words, in_b)) {
            continue;
        }
        ++result.differing;
        if (result.places.size() < places_kept) {
            result.places.push_back(static_cast<std::uint32_t>(i));
        }
        bool beyond = true;
        if (form.floats) {
            const double error = distance(in_a, in_b, form.words);
            beyond = !(i < bounds.size() && error <= bounds[i]);
            result.of_bound = beyond ? result.of_bound : std::max(result.of_bound, error / bounds[i]);
            result.max_error = std::max(result.max_error, error);
            for (std::size_t w = 0; w < form.words; ++w) {
                result.max_ulp = std::max(result.max_ulp,
                                          ulp_distance(std::bit_cast<float>(in_a[w]), std::bit_cast<float>(in_b[w])));
            }
        }
        result.beyond_bound += beyond ? 1 : 0;
        if (result.first.empty() || (beyond && !first_is_beyond)) {
            result.first = std::string(form.element) + " " + std::to_string(i) + ": GPU " + element_text(in_a, form) +
                           ", CPU " + element_text(in_b, form);
            first_is_beyond = beyond;
        }
    }
    return result;
}

}  // namespace ballpit::measure
