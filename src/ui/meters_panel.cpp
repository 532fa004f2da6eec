#include "ui/meters_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "ui/meters_plot.h"
#include "ui/style.h"
#include "ui/tool_window.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

constexpr std::array<vec3, 3> light_colours = {vec3(0.00f, 0.62f, 0.45f), vec3(0.90f, 0.62f, 0.00f),
                                               vec3(0.84f, 0.37f, 0.00f)};
constexpr std::array<const char*, 3> light_words = {"good", "close", "beyond"};

void swatch(ImU32 colour) {
    const float size = 0.7f * em();
    const ImVec2 place = ImGui::GetCursorScreenPos();
    const float y = place.y + 0.5f * (ImGui::GetTextLineHeight() - size);
    ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(place.x, y), ImVec2(place.x + size, y + size), colour);
    ImGui::Dummy(ImVec2(size, size));
    ImGui::SameLine();
}

void band_row(ImU32 colour, std::string_view name, double energy, double total) {
    ImGui::TableNextColumn();
    swatch(colour);
    text(name);
    ImGui::TableNextColumn();
    text(format("%.4g J", energy));
    ImGui::TableNextColumn();
    dim_text(total > 0.0 && std::isfinite(energy) ? format("%.2f %%", 100.0 * energy / total) : "");
}

// Two bands a row.
void bands(const MetersState& meters) {
    const measure::Balance& balance = *meters.balance;
    const double lowest = lowest_potential(meters.series);
    const auto shown = bands_of(balance, lowest);
    const double total = balance.start + balance.work - lowest;
    if (!ImGui::BeginTable("bands", 6, ImGuiTableFlags_SizingFixedFit)) {
        return;
    }
    for (int column = 0; column < 6; ++column) {  // numbers change: columns that follow them would jump
        constexpr std::array widths = {8.0f, 6.5f, 4.5f};
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed,
                                widths[static_cast<std::size_t>(column % 3)] * em());
    }
    for (std::size_t band = 0; band < energy_bands; ++band) {
        band_row(band_colour(band), band_names[band], shown[band], total);
    }
    band_row(unexplained_colour(), "unexplained", balance.unexplained(), total);
    band_row(packed(text_colour), "work put in", balance.work, total);
    ImGui::EndTable();
}

void number_row(const char* name, const std::string& value, const char* about) {
    ImGui::TableNextColumn();
    dim_text(name);
    tooltip(about);
    ImGui::TableNextColumn();
    text(value);
}

std::string vector_text(const dvec3& v, const char* unit) { return format("%.3g  %.3g  %.3g %s", v.x, v.y, v.z, unit); }

void numbers(const MeterRecord& record) {
    const MeterReading& r = record.reading;
    if (!ImGui::BeginTable("numbers", 4, ImGuiTableFlags_SizingFixedFit)) {
        return;
    }
    for (const float width : {9.5f, 14.0f, 7.5f, 11.0f}) {
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, width * em());
    }
    number_row("momentum", vector_text(r.momentum, "kg m/s"), "Of all balls, x y z.");
    number_row("fastest", format("%.4g m/s", r.max_speed), "The fastest ball.");
    number_row("angular momentum", vector_text(r.angular_momentum, "kg m²/s"), "About the centre of the box, x y z.");
    number_row("contacts",
               format("%s and %s", grouped(static_cast<unsigned long long>(0.5 * r.contact_ends)).c_str(),
                      grouped(static_cast<unsigned long long>(r.wall_contacts)).c_str()),
               "Pairs of balls that touch, and balls at walls.");
    number_row("largest overlap", format("%.3g %% of D, %.3g mm", 100.0 * r.max_overlap_share, 1e3 * r.max_overlap),
               "Of the sum of both radii, or of the diameter at a wall.");
    number_row("mean overlap", format("%.3g %% of D", 100.0 * r.mean_overlap_share()), "Over all contacts.");
    const double weight = record.weight();
    number_row("force on the floor", format("%.4g N", r.floor_force), "Of the lower wall along z on all balls.");
    number_row("weight", weight > 0.0 ? format("%.4g N: %.1f %%", weight, 100.0 * r.floor_force / weight) : "none",
               "Of all balls, and how much of it the floor carries: all, in a pile at rest.");
    ImGui::EndTable();
}

void remedy_button(const measure::Gauge& gauge, const State& state, Commands& commands) {
    if (!gauge.remedy) {
        return;
    }
    const std::string label = gauge.remedy->key + " = " + gauge.remedy->value + "##" + std::string(gauge.name);
    if (ImGui::Button(label.c_str())) {
        ChangeSettings change{state.settings};
        assign_setting(change.settings, gauge.remedy->key, gauge.remedy->value);
        commands.push_back(change);
    }
    tooltip("The setting that turns this gauge green.");
}

void gauge_row(const measure::Gauge& gauge, const State& state, Commands& commands) {
    const auto light = static_cast<std::size_t>(gauge.light());
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    swatch(packed(light_colours[light]));
    text(light_words[light]);
    ImGui::TableNextColumn();
    text(gauge.name);
    const char* order = gauge.low_is_bad ? "at least" : "below";
    const std::string unit = gauge.unit.empty() ? "" : " " + std::string(gauge.unit);
    text(format("%.3g", gauge.value) + unit);
    ImGui::TableNextColumn();
    wrapped_dim_text(gauge.text + format(" Good: %s %.3g.", order, gauge.amber));
    remedy_button(gauge, state, commands);
}

void gauge_table(const State& state, Commands& commands) {
    constexpr auto flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerH;
    if (!ImGui::BeginTable("gauges", 3, flags)) {
        return;
    }
    ImGui::TableSetupColumn("light", ImGuiTableColumnFlags_WidthFixed, 5.0f * em());
    ImGui::TableSetupColumn("gauge", ImGuiTableColumnFlags_WidthFixed, 10.0f * em());
    ImGui::TableSetupColumn("about", ImGuiTableColumnFlags_WidthStretch);
    for (const measure::Light light : {measure::Light::red, measure::Light::amber, measure::Light::green}) {
        for (const measure::Gauge& gauge : state.meters->gauges) {
            if (gauge.light() == light) {
                gauge_row(gauge, state, commands);
            }
        }
    }
    ImGui::EndTable();
}

void cost_row(const MetersState& meters, Commands& commands) {
    if (ImGui::Button("Start anew")) {
        commands.push_back(RestartMeters{});
    }
    tooltip("The balance begins with the next moment.");
    ImGui::SameLine();
    wrapped_dim_text(
        meters.ms ? format("Every substep is metered: %.3g ms more for each. Closed, it costs nothing.", *meters.ms)
                  : "Every substep is metered while this window is open. Closed, it costs nothing.");
}

}  // namespace

void meters_section(Commands& commands) {
    if (section("Meters", false) &&
        key_button("Energy and stability", key_hint(Action::toggle_meters), column_width(1))) {
        commands.push_back(Action::toggle_meters);
    }
}

void meters_panel(const State& state, Commands& commands) {
    const MetersState& meters = *state.meters;
    cost_row(meters, commands);
    if (!meters.record || !meters.balance) {
        wrapped_dim_text("Waiting for the first substep …");
        return;
    }
    if (!(meters.record->reading.mass > 0.0)) {
        wrapped_dim_text("No balls: there is nothing to meter.");
        return;
    }
    energy_plot(meters.series, ImVec2(ImGui::GetContentRegionAvail().x, 9.0f * em()));
    wrapped_dim_text(
        format("%.4g s to %.4g s. Energy that was moved by hand (stiffness, gravity, laws, balls), another "
               "integrator, or a step back begin a new balance.",
               meters.balance->base_time, meters.balance->time));
    bands(meters);
    ImGui::Separator();
    numbers(*meters.record);
    ImGui::Separator();
    gauge_table(state, commands);
}

void draw_meters_window(const State& state, Commands& commands) {
    if (state.meters == nullptr) {
        return;
    }
    const ImVec2 room = free_room(state);
    const float below_rate = 6.0f * em();
    const ImVec2 size(std::min(44.0f * em(), room.x), room.y - below_rate);
    if (!tool_window(state, "Meters", ImVec2(window_margin(), below_rate), size,
                     [&] { meters_panel(state, commands); })) {
        commands.push_back(Action::toggle_meters);
    }
}

}  // namespace ballpit::ui
