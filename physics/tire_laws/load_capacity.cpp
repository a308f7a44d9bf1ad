// SPDX-License-Identifier: BSD-3-Clause
// Tables of load indices and speed symbols, and the power law of the pressure.
#include "physics/tire_laws/load_capacity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace tiretherm::physics {

namespace {

constexpr double gravity = 9.80665;
constexpr int first_index = 50;
/// kg, of the indices from 50 on.
constexpr std::array loads{
    190,  195,  200,  206,  212,  218,  224,  230,  236,  243,  250,  257,  265,  272,  280,  290,  300,  307,  315,
    325,  335,  345,  355,  365,  375,  387,  400,  412,  425,  437,  450,  462,  475,  487,  500,  515,  530,  545,
    560,  580,  600,  615,  630,  650,  670,  690,  710,  730,  750,  775,  800,  825,  850,  875,  900,  925,  950,
    975,  1000, 1030, 1060, 1090, 1120, 1150, 1180, 1215, 1250, 1285, 1320, 1360, 1400, 1450, 1500, 1550, 1600, 1650,
    1700, 1750, 1800, 1850, 1900, 1950, 2000, 2060, 2120, 2180, 2240, 2300, 2360, 2430, 2500, 2575, 2650, 2725, 2800,
    2900, 3000, 3075, 3150, 3250, 3350, 3450, 3550, 3650, 3750, 3875, 4000, 4125, 4250, 4375, 4500};
constexpr std::string_view symbols = "FGJKLMNPQRSTUHVWY";
constexpr std::array kmh{80, 90, 100, 110, 120, 130, 140, 150, 160, 170, 180, 190, 200, 210, 240, 270, 300};
static_assert(symbols.size() == kmh.size());

}  // namespace

std::optional<double> ServiceDescription::load() const {
    const auto place = static_cast<std::size_t>(load_index - first_index);
    return load_index >= first_index && place < loads.size() ? std::optional(gravity * loads[place]) : std::nullopt;
}

std::optional<double> ServiceDescription::speed() const {
    const std::size_t place = symbols.find(speed_symbol);
    return place == std::string_view::npos ? std::nullopt : std::optional(kmh[place] / 3.6);
}

double load_capacity(double load, double pressure, double reference) {
    return load * std::pow(std::clamp(pressure / reference, 0.0, 1.0), 0.8);
}

}  // namespace tiretherm::physics
