#include "app/probe_legend.h"

#include "app/probe_overlay.h"
#include "ui/widgets.h"

namespace ballpit::app {

namespace {

ui::Legend bar(std::string title, view::Palette palette, float low, float high, std::string_view unit) {
    const view::ContinuousLegend from = view::continuous_legend(palette, low, high, unit);
    ui::Legend legend{std::move(title), from.colours, {}, {}};
    for (const view::LegendTick& tick : from.ticks) {
        legend.ticks.push_back({tick.place, tick.text});
    }
    return legend;
}

ui::Legend words(std::string title) { return {std::move(title), {}, {}, {}}; }

void add_ball_colour(std::vector<ui::Legend>& legends, const LegendInput& in) {
    using view::Palette;
    switch (in.colour) {
        case ui::BallColour::tinted:
        case ui::BallColour::plain:
            return;
        case ui::BallColour::speed:
            legends.push_back(bar("Balls: speed", Palette::sequential, 0.0f, in.top_speed, "m/s"));
            return;
        case ui::BallColour::cell:
            legends.push_back(words("Balls: one colour a cell"));
            return;
        case ui::BallColour::slot:
            legends.push_back(
                bar("Balls: slot in the sorted keys", Palette::sequential, in.value_low, in.value_high, ""));
            return;
        case ui::BallColour::contacts:
            legends.push_back(bar("Balls: contacts with others", Palette::sequential, in.value_low, in.value_high, ""));
            return;
        case ui::BallColour::difference:
            if (!in.checked) {
                legends.push_back(words("Balls: difference to the mirror"));
                legends.back().entries.push_back({view::no_value_colour, "switch the check to the mirror: K"});
            } else if (in.value_high == 0.0f) {
                legends.push_back(words("Balls: no difference to the mirror"));
            } else {
                legends.push_back(bar("Balls: velocity, difference to the mirror", Palette::sequential, in.value_low,
                                      in.value_high, "m/s"));
            }
            return;
        case ui::BallColour::radius:
            if (in.value_low == in.value_high) {
                legends.push_back(
                    words("Balls: radius, " + ui::short_number(static_cast<double>(in.value_low)) + " m for all"));
            } else {
                legends.push_back(bar("Balls: radius", Palette::sequential, in.value_low, in.value_high, "m"));
            }
            return;
    }
}

void add_contacts(std::vector<ui::Legend>& legends, const LegendInput& in) {
    if (in.work == nullptr || !(in.options.contacts || in.options.split)) {
        return;
    }
    const measure::FoundPairs& pairs = in.work->pairs;
    if (in.options.contacts) {
        legends.push_back(bar("Contacts: overlap", view::Palette::sequential, 0.0f, 1000.0f * in.top_overlap, "mm"));
        std::string found = ui::grouped(pairs.found.size()) + " found, the largest " +
                            ui::short_number(1000.0 * static_cast<double>(in.work->largest_overlap)) + " mm";
        if (pairs.found.size() > most_contact_lines) {
            found += "; the first " + ui::grouped(most_contact_lines) + " are drawn";
        }
        legends.back().entries.push_back({vec3(view::sequential(1.0f)), found});
    } else if (!pairs.missed.empty()) {
        legends.push_back(words("Lines"));
    }
    if (!pairs.missed.empty()) {
        legends.back().entries.push_back(
            {vec3(missed_colour), ui::grouped(pairs.missed.size()) + " that the grid misses"});
    }
}

}  // namespace

std::vector<ui::Legend> make_legends(const LegendInput& in) {
    std::vector<ui::Legend> legends;
    add_ball_colour(legends, in);
    add_contacts(legends, in);
    if (in.following) {
        ui::Legend legend = words("Followed ball");
        legend.entries = {{vec3(chosen_colour), "the ball and its cell"},
                          {vec3(touched_colour), "tested, touches it"},
                          {vec3(tested_colour), "tested, does not touch"},
                          {vec3(searched_colour), "cells looked through"}};
        legends.push_back(legend);
    }
    if (in.options.slice || in.occupancy) {
        legends.push_back(bar(in.options.slice ? "Slice: balls in a cell" : "Cells: balls in a cell",
                              view::Palette::sequential, 1.0f, static_cast<float>(in.top_count), ""));
    }
    if (in.options.arrows) {
        legends.push_back(
            words("Arrows: the way in " + ui::short_number(static_cast<double>(in.options.arrow_seconds)) + " s"));
    }
    return legends;
}

}  // namespace ballpit::app
