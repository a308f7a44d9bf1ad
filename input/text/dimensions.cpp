// SPDX-License-Identifier: BSD-3-Clause
// Names of physical dimensions with an example for error messages: "a length", "8 mm".

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "input/text/units.hpp"

namespace tiretherm::input {

namespace {

/// Any unit of a dimension, and the dimension.
using Named = std::pair<std::string_view, Dimension>;

const std::array names{
    Named{"1", {"a pure number", "0.6", "1 %"}},
    Named{"m", {"a length", "8 mm", "mm cm m"}},
    Named{"m2", {"an area", "1 cm2", "mm2 cm2 m2"}},
    Named{"m3", {"a volume", "1 cm3"}},
    Named{"s", {"a time", "60 s", "s min h ms"}},
    Named{"kg", {"a mass", "8 kg", "kg g"}},
    Named{"K", {"a temperature", "25 degC", "degC K degF"}},
    Named{"A", {"an electric current", ""}},
    Named{"C", {"an electric charge", ""}},
    Named{"F", {"an electric capacitance", ""}},
    Named{"radian", {"an angle", "2 deg", "deg rad"}},
    Named{"m s-1", {"a speed", "100 km/h", "km/h m/s mph"}},
    Named{"m s-2", {"an acceleration", "9.81 m/s2"}},
    Named{"N", {"a force", "4000 N", "N kN lbf"}},
    Named{"J", {"an energy", "1 J", "J kJ kWh"}},
    Named{"W", {"a power", "1 W", "W kW mW"}},
    Named{"Pa", {"a pressure", "220 kPa", "kPa bar psi MPa Pa"}},
    Named{"Hz", {"a frequency", "52 Hz", "Hz kHz"}},
    Named{"rad s-1", {"an angular speed", "100 rad/s", "rad/s rpm"}},
    Named{"kg m-3", {"a density", "1100 kg/m3", "kg/m3 g/cm3"}},
    Named{"J kg-1 K-1", {"a specific heat capacity", "1800 J/kgK", "J/kgK kJ/kgK"}},
    Named{"W m-1 K-1", {"a thermal conductivity", "0.29 W/mK", "W/mK mW/mK"}},
    Named{"W m-1 K-2", {"a slope of conductivity", "0.009 W/mK/K"}},
    Named{"W m-1 K-3", {"a curvature of conductivity", "1e-5 W/mK/K2"}},
    Named{"J kg-1 K-2", {"a slope of heat capacity", "5 J/kgK/K"}},
    Named{"J kg-1 K-3", {"a curvature of heat capacity", "0.1 J/kgK/K2"}},
    Named{"W m-2 K-1", {"a heat transfer coefficient", "10 W/m2K", "W/m2K kW/m2K"}},
    Named{"W m-2", {"a heat flux", "1e4 W/m2", "W/m2 kW/m2"}},
    Named{"W m-3", {"a power per volume", "1e5 W/m3", "W/m3 kW/m3"}},
    Named{"W K-1", {"a thermal conductance", "8 W/K", "W/K"}},
    Named{"J K-1", {"a heat capacity", "70 J/K", "J/K kJ/K"}},
    Named{"m2 s-1", {"a diffusivity or kinematic viscosity", "1.5e-5 m2/s"}},
    Named{"K-1", {"a rate per kelvin", "0.01 1/K"}},
    Named{"m-1", {"a curvature or a number per length", "0.5 1/m"}},
    Named{"radian-1", {"a rate per angle", "10 1/rad"}},
    Named{"J kg-1", {"a specific energy", "2.45e6 J/kg"}},
    Named{"J m-3 K-1", {"a heat capacity per volume", "2e6 J/m3K"}},
    Named{"s2 m-2", {"a reciprocal square of a speed", "1e-5 s2/m2"}},
    Named{"N-1", {"a rate per force", "0.35 1/kN"}},
    Named{"N radian-1", {"a stiffness against an angle", "80 kN/rad"}},
    Named{"kg m2", {"a moment of inertia", "1800 kg m2"}},
    Named{"m N-1", {"a length per force", "-4.2e-6 m/N"}},
    Named{"m2 N-1", {"an area per force", "2.333e-6 m2/N"}},
    Named{"K s-1", {"a rate of temperature", "2 K/h"}},
    Named{"s m-1", {"a reciprocal speed", "0.01 s/m"}},
};

}  // namespace

Dimension dimension(std::string_view unit, Scale scale) {
    const std::string wanted = signature(unit);
    if (wanted == "K" && scale == Scale::difference) {
        return {"a difference of temperatures", "0.5 K", "K degC"};
    }
    for (const auto& [of, named] : names) {
        if (signature(of) == wanted) {
            return named;
        }
    }
    return {fmt::format("a quantity in {}", wanted), ""};
}

std::vector<Dimension> dimensions() {
    std::vector<Dimension> all;
    std::ranges::transform(names, std::back_inserter(all), &Named::second);
    return all;
}

}  // namespace tiretherm::input
