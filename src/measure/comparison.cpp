#include "measure/comparison.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "core/backend.h"
#include "measure/slot_table.h"

namespace ballpit::measure {

namespace {

constexpr std::size_t places_kept = 1000;

std::string whole_element_text(Slot slot, std::span<const std::byte> bytes, std::size_t element) {
    std::string text = "(";
    for (std::size_t column = 0; column < slot_columns(slot).size(); ++column) {
        text.append(column == 0 ? "" : ", ").append(element_text(slot, bytes, element, column));
    }
    return text + ")";
}

bool both_nan(float a, float b) { return std::isnan(a) && std::isnan(b); }

// Largest distance of the floats of an element; infinite where only one of them is no number. Of two that are none the
// bits say nothing: OpenGL promises none.
double distance(const std::uint32_t* a, const std::uint32_t* b, std::size_t words) {
    double largest = 0.0;
    for (std::size_t i = 0; i < words; ++i) {
        if (a[i] == b[i]) {
            continue;
        }
        const auto ours = std::bit_cast<float>(a[i]);
        const auto theirs = std::bit_cast<float>(b[i]);
        const double d =
            both_nan(ours, theirs) ? 0.0 : std::abs(static_cast<double>(ours) - static_cast<double>(theirs));
        largest = std::isnan(d) ? INFINITY : std::max(largest, d);
    }
    return largest;
}

}  // namespace

std::uint64_t ulp_distance(float a, float b) {
    const auto bits_a = std::bit_cast<std::uint32_t>(a);
    const auto bits_b = std::bit_cast<std::uint32_t>(b);
    if (bits_a == bits_b || both_nan(a, b)) {
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

Comparison compare_slot(Slot slot, std::span<const std::byte> gpu, std::span<const std::byte> cpu,
                        std::span<const double> bounds) {
    const std::size_t words = slot_columns(slot).size();
    const bool floats = slot_columns(slot).front().is_float;
    const auto a = typed<std::uint32_t>(gpu);
    const auto b = typed<std::uint32_t>(cpu);
    const std::size_t common = std::min(a.size(), b.size()) / words;
    Comparison result;
    result.elements = std::max(a.size(), b.size()) / words;
    result.differing = result.beyond_bound = result.elements - common;
    if (result.elements != common) {
        result.first =
            "GPU has " + std::to_string(a.size() / words) + " elements, CPU " + std::to_string(b.size() / words);
    }
    bool first_is_beyond = result.beyond_bound != 0;
    for (std::size_t i = 0; i < common; ++i) {
        const std::uint32_t* in_a = &a[i * words];
        const std::uint32_t* in_b = &b[i * words];
        if (std::equal(in_a, in_a + words, in_b)) {
            continue;
        }
        ++result.differing;
        if (result.places.size() < places_kept) {
            result.places.push_back(static_cast<std::uint32_t>(i));
        }
        bool beyond = true;
        if (floats) {
            const double error = distance(in_a, in_b, words);
            beyond = error != 0.0 && !(i < bounds.size() && error <= bounds[i]);
            result.of_bound = beyond || error == 0.0 ? result.of_bound : std::max(result.of_bound, error / bounds[i]);
            result.max_error = std::max(result.max_error, error);
            for (std::size_t w = 0; w < words; ++w) {
                result.max_ulp = std::max(result.max_ulp,
                                          ulp_distance(std::bit_cast<float>(in_a[w]), std::bit_cast<float>(in_b[w])));
            }
        }
        result.beyond_bound += beyond ? 1 : 0;
        if (result.first.empty() || (beyond && !first_is_beyond)) {
            result.first = std::string(slot_element(slot)) + " " + std::to_string(i) + ": GPU " +
                           whole_element_text(slot, gpu, i) + ", CPU " + whole_element_text(slot, cpu, i);
            first_is_beyond = beyond;
        }
    }
    return result;
}

}  // namespace ballpit::measure
