#include "ui/probe.h"

#include <cmath>

#include "ui/widgets.h"

namespace ballpit::ui {

std::string short_number(double value) {
    if (!std::isfinite(value)) {
        return std::isnan(value) ? "NaN" : value < 0.0 ? "−∞" : "∞";
    }
    std::string text = format("%.3g", std::abs(value));
    return value < 0.0 && text != "0" ? "−" + text : text;
}

std::string range_text(std::uint64_t first, std::uint64_t end) {
    if (end <= first + 1) {
        return grouped(first);
    }
    return grouped(first) + "…" + grouped(end - 1);
}

}  // namespace ballpit::ui
