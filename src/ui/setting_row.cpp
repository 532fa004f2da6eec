#include "ui/setting_row.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

constexpr double decades_each_side = 1e3;

double default_value(const SettingInfo& info, const Settings& defaults) {
    if (const auto* real = std::get_if<double Settings::*>(&info.member)) {
        return defaults.*(*real);
    }
    return 0.0;
}

std::string with_unit(const char* number, const SettingInfo& info) {
    return info.unit.empty() ? number : std::string(number) + " " + shown_unit(info.unit);
}

std::string spaced(std::string_view name) {
    std::string words(name);
    std::ranges::replace(words, '_', ' ');
    return words;
}

// One control per type that a setting can have; std::visit picks. Typed values are clamped here, to the setting's
// range and not to the slider's.
struct Control {
    const SettingInfo& info;
    const State& state;
    Settings& edited;

    bool operator()(double Settings::*member) const {
        const SliderRange range = slider_range(info, state.defaults, state.most_balls);
        double value = edited.*member;
        const ImGuiSliderFlags flags = range.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None;
        if (!ImGui::SliderScalar("##value", ImGuiDataType_Double, &value, &range.low, &range.high,
                                 with_unit(std::abs(value) >= 1e4 ? "%.0f" : "%.4g", info).c_str(), flags) ||
            !std::isfinite(value)) {
            return false;
        }
        edited.*member = std::clamp(value, info.minimum, info.maximum);
        return true;
    }

    bool operator()(std::uint32_t Settings::*member) const {
        const SliderRange range = slider_range(info, state.defaults, state.most_balls);
        const auto low = static_cast<std::int64_t>(range.low);
        const auto high = static_cast<std::int64_t>(range.high);
        std::int64_t value = edited.*member;  // signed: a typed -5 must not wrap
        const ImGuiSliderFlags flags = range.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None;
        if (!ImGui::SliderScalar("##value", ImGuiDataType_S64, &value, &low, &high, with_unit("%lld", info).c_str(),
                                 flags)) {
            return false;
        }
        const auto most =
            member == &Settings::balls ? std::int64_t{state.most_balls} : static_cast<std::int64_t>(info.maximum);
        edited.*member = static_cast<std::uint32_t>(std::clamp(value, static_cast<std::int64_t>(info.minimum), most));
        return true;
    }

    bool operator()(bool Settings::*member) const { return ImGui::Checkbox("##value", &(edited.*member)); }

    bool operator()(dvec3 Settings::*member) const {
        dvec3 value = edited.*member;
        if (!ImGui::DragScalarN("##value", ImGuiDataType_Double, &value.x, 3, 0.1f, &info.minimum, &info.maximum,
                                "%.4g")) {
            return false;
        }
        for (int axis = 0; axis < 3; ++axis) {
            if (!std::isfinite(value[axis])) {
                return false;
            }
            value[axis] = std::clamp(value[axis], info.minimum, info.maximum);
        }
        edited.*member = value;
        return true;
    }

    bool operator()(Integrator Settings::*member) const { return choice(edited.*member); }
    bool operator()(SortMethod Settings::*member) const { return choice(edited.*member); }
    bool operator()(NeighbourSearch Settings::*member) const { return choice(edited.*member); }
    bool operator()(DashpotMethod Settings::*member) const { return choice(edited.*member); }

    template <class Enum>
    bool choice(Enum& value) const {
        const auto names = setting_choices(info);
        const auto chosen = static_cast<std::size_t>(value);
        if (!ImGui::BeginCombo("##value", spaced(names[chosen]).c_str())) {
            return false;
        }
        if (state.close_popups) {
            ImGui::CloseCurrentPopup();
        }
        bool changed = false;
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (ImGui::Selectable(spaced(names[i]).c_str(), i == chosen) && i != chosen) {
                value = static_cast<Enum>(i);
                changed = true;
            }
        }
        ImGui::EndCombo();
        return changed;
    }

    // These have no row.
    bool operator()(Laws Settings::*) const { return false; }
    bool operator()(std::optional<Pull> Settings::*) const { return false; }
};

bool differs(const SettingInfo& info, const Settings& a, const Settings& b) {
    return setting_text(info, a) != setting_text(info, b);
}

}  // namespace

SliderRange slider_range(const SettingInfo& info, const Settings& defaults, std::uint32_t most_balls) {
    if (info.key == "balls" && most_balls < maximum_balls) {
        return {0.0, static_cast<double>(most_balls), false};
    }
    if (!info.logarithmic) {
        return {info.minimum, info.maximum, false};
    }
    if (std::holds_alternative<std::uint32_t Settings::*>(info.member)) {
        return {std::max(info.minimum, 1.0), info.maximum, true};
    }
    const double middle = default_value(info, defaults);
    if (middle <= 0.0) {
        return {info.maximum / (decades_each_side * decades_each_side), info.maximum, true};
    }
    return {std::max(info.minimum, middle / decades_each_side), std::min(info.maximum, middle * decades_each_side),
            true};
}

std::string shown_unit(std::string_view unit) {
    std::string shown;
    for (std::size_t i = 0; i < unit.size(); ++i) {
        if (unit[i] == '^' && i + 1 < unit.size() && (unit[i + 1] == '2' || unit[i + 1] == '3')) {
            shown += unit[++i] == '2' ? "²" : "³";
        } else {
            shown += unit[i] == '%' ? "%%" : std::string(1, unit[i]);
        }
    }
    return shown;
}

bool has_row(const SettingInfo& info) {
    return !std::holds_alternative<Laws Settings::*>(info.member) &&
           !std::holds_alternative<std::optional<Pull> Settings::*>(info.member) && info.needs[0] != &Laws::walls &&
           info.needs[0] != &Laws::shake;
}

bool setting_row(const SettingInfo& info, const State& state, Settings& edited) {
    const float button = ImGui::GetFrameHeight();
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float end = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
    ImGui::PushID(info.key.data(), info.key.data() + info.key.size());
    std::string about(info.about);
    if (!info.unit.empty()) {
        about.append(" Unit: ").append(shown_unit(info.unit)).append(".");
    }
    row_label(info.label, about, button + gap);
    bool changed = std::visit(Control{info, state, edited}, info.member);
    if (differs(info, edited, state.defaults)) {
        ImGui::SameLine(end - button);
        if (ImGui::Button("↺", ImVec2(button, 0.0f))) {
            assign_setting(edited, info.key, setting_text(info, state.defaults));
            changed = true;
        }
        const std::string own = setting_text(info, state.defaults);
        tooltip(format("Back to the scene's own value: %s %s", own.c_str(), shown_unit(info.unit).c_str()));
    }
    ImGui::PopID();
    return changed;
}

}  // namespace ballpit::ui
