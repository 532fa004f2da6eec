// The energy of a run as bands over time, one on the other.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "measure/energy_balance.h"
#include "ui/style.h"

namespace ballpit::ui {

inline constexpr std::size_t energy_bands = 6;
inline constexpr std::array<std::string_view, energy_bands> band_names = {
    "kinetic", "potential", "elastic", "heat: drag", "heat: contacts", "heat: walls"};
ImU32 band_colour(std::size_t band);
ImU32 unexplained_colour();

/// J of each band, none below 0; the potential energy counts from `lowest`, the lowest of the series.
std::array<double, energy_bands> bands_of(const measure::Balance& balance, double lowest);
double lowest_potential(std::span<const measure::Balance> series);

/// The bands, and the energy that there should be (at the base, and the work since) as a line: what lies between the
/// line and the bands is unexplained, and hatched.
void energy_plot(std::span<const measure::Balance> series, ImVec2 size);

}  // namespace ballpit::ui
