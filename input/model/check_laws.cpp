// SPDX-License-Identifier: BSD-3-Clause
// Checks that conductivity and heat capacity are positive at all temperatures of the case; warns of trouble between -40
// and 200 degC, of unused materials, of cords that the mesh cannot show, and of inputs outside the ranges of the tire's laws.

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "input/model/materials.hpp"
#include "input/model/tire.hpp"
#include "physics/celsius.hpp"

namespace tiretherm::input {

namespace {

using physics::Curve;

/// The lowest and the highest temperature that the case gives: initial state and surroundings.
struct TemperatureSpan {
    double low = 0.0;
    double high = 0.0;

    void take(double T) {
        low = std::min(low, T);
        high = std::max(high, T);
    }
};

TemperatureSpan given_temperatures(const solver::Problem& problem) {
    // A start that could not be read (the air of a file that is not there) is no temperature.
    constexpr double room = 293.15;
    const auto known = std::ranges::find_if(problem.initial, [](double T) { return T > 0.0; });
    const double first = known == problem.initial.end() ? room : *known;
    TemperatureSpan span{first, first};
    for (const double T : problem.initial) {
        if (T > 0.0) {
            span.take(T);
        }
    }
    const solver::InputSignals& input_signals = problem.input_signals;
    for (const physics::Signal& signal : physics::signals()) {
        if (signal.unit == "K" && input_signals.gives(signal)) {
            if (const double T = input_signals.constants().*signal.member; T > 0.0) {
                span.take(T);
            }
        }
    }
    for (const solver::Series& series : input_signals.series()) {
        if (series.signal->unit == "K") {
            for (const double T : series.value) {
                span.take(T);
            }
        }
    }
    return span;
}

/// Between these a tire may be run: a law that fails there is told, whatever the case.
constexpr double coldest_tire = zero_celsius - 40.0;
constexpr double hottest_tire = zero_celsius + 200.0;

/// Where a law is smallest, to a thousandth of the span.
double lowest_place(const Curve& law, const TemperatureSpan& span) {
    double lowest = span.low;
    // For the message alone: whether a law fails is known in closed form.
    for (int i = 1; i <= 1000; ++i) {
        const double T = span.low + (span.high - span.low) * i / 1000.0;
        lowest = law.value(T) < law.value(lowest) ? T : lowest;
    }
    return lowest;
}

/// @param unit as users write it
void check_law(InputErrors& errors, const Curve& law, const std::string& what, std::string_view unit,
               const SourceLocation& place, const TemperatureSpan& sure) {
    if (!(law.minimum(sure.low, sure.high) > 0.0)) {
        const double T = lowest_place(law, sure);
        errors.add(place,
                   fmt::format("{} is {:.3g} {} at {:.1f} degC, a temperature of this case", what, law.value(T), unit,
                               celsius(T)),
                   "correct the law: conductivity and heat capacity must be positive");
        return;
    }
    const TemperatureSpan tire{std::min(sure.low, coldest_tire), std::max(sure.high, hottest_tire)};
    if (!(law.minimum(tire.low, tire.high) > 0.0)) {
        const double T = lowest_place(law, tire);
        errors.warn(place,
                    "{} is {:.3g} {} at {:.0f} degC, and a tire may be run between -40 and 200 degC: hold "
                    "the law where it was measured, range = [\"20 degC\", \"120 degC\"]",
                    what, law.value(T), unit, celsius(T));
    }
}

/// The effect is for belts whose material does not know its cords.
void warn_of_second_anisotropy(InputErrors& errors, const solver::Problem& problem, const Stock& stock) {
    for (const physics::ActiveEffect& active : problem.effects) {
        const bool acts = std::ranges::any_of(active.layers, [&](int layer) {
            return problem.materials[static_cast<std::size_t>(layer)].name == stock.material.name;
        });
        if (acts && active.effect->id == "belt_anisotropy") {
            errors.warn(stock.ply->place,
                        "belt_anisotropy multiplies the conductivities of {} along the "
                        "belt, which follow from its cords already",
                        stock.material.name);
        }
    }
}

/// Shares of the reference pressure between which Rhyne's stiffness and the exponent of SAE J2452 are taken to hold, assumed:
/// 110 to 370 kPa of tires inflated to 220 kPa.
constexpr double least_pressure = 0.5;
constexpr double most_pressure = 1.7;
/// Of the section's height; beyond it the sidewalls fold and the rim comes near the road.
constexpr double most_deflection = 0.4;

/// Extremes of what the run gives, as far as the inputs bend: at their samples and stops.
struct Seen {
    double least_pressure = 0.0;
    double most_pressure = 0.0;
    double deflection = 0.0;
    double load = 0.0;  ///< at the largest deflection
    double time = 0.0;
};

Seen look_at(const solver::Problem& problem) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const solver::InputSignals& signals = problem.input_signals;
    Seen seen{.least_pressure = infinite, .most_pressure = -infinite};
    const auto look = [&](double t, solver::JumpSide side) {
        const physics::Inputs in = signals.at(t, side);
        seen.least_pressure = std::min(seen.least_pressure, in.inflation_pressure);
        seen.most_pressure = std::max(seen.most_pressure, in.inflation_pressure);
        const double deflection = problem.tire.touches(in.vertical_load)
                                      ? problem.tire.unloaded_radius - problem.tire.loaded_radius(in)
                                      : 0.0;
        if (deflection > seen.deflection) {
            seen.deflection = deflection;
            seen.load = in.vertical_load;
            seen.time = t;
        }
    };
    look(problem.settings.start, solver::JumpSide::before);
    look(problem.settings.start, solver::JumpSide::after);
    for (const double t : signals.stops()) {
        look(t, solver::JumpSide::before);
        look(t, solver::JumpSide::after);
    }
    for (const double t : signals.samples()) {  // a jump is a stop
        look(t, solver::JumpSide::before);
    }
    return seen;
}

}  // namespace

void check_laws(TomlTable& root, const solver::Problem& problem, const std::vector<Stock>& all) {
    if (problem.initial.empty()) {
        return;
    }
    const TemperatureSpan sure = given_temperatures(problem);
    for (const Stock& stock : all) {
        const physics::Material& material = stock.material;
        if (!stock.used) {
            root.errors().warn(stock.table->place, "no layer is made of the material \"{}\"", material.name);
            continue;
        }
        const auto check = [&](const Curve& law, std::string_view key, std::string_view what) {
            const TomlValue* value = stock.table->find(key);
            if (value != nullptr) {
                const std::string_view unit = key == "heat_capacity" ? "J/kgK" : "W/mK";
                check_law(root.errors(), law, fmt::format("the {} of {}", what, material.name), unit, value->place,
                          sure);
            }
        };
        check(material.heat_capacity, "heat_capacity", "heat capacity");
        check(material.along(mesh::Axis::through), "conductivity", "conductivity");
        check(material.along(mesh::Axis::meridian), "conductivity_meridian", "conductivity along the meridian");
        check(material.along(mesh::Axis::circumference), "conductivity_circumference",
              "conductivity along the circumference");
        if (stock.ply) {
            check_cord_rubber(*stock.ply, material.name, problem.mesh, root.errors());
            warn_of_second_anisotropy(root.errors(), problem, stock);
        }
    }
    const TomlValue* link = root.content().find("mesh")->find("link_conductivity");
    if (link != nullptr && !problem.link_laws.empty()) {
        check_law(root.errors(), problem.link_laws.front(), "the conductivity of the link", "W/mK", link->place, sure);
    }
}

void settle_tire(TomlTable& root, bool has_tire, const GivenSignals& given, solver::Problem& problem) {
    InputErrors& errors = root.errors();
    const auto gives = [&](std::string_view name) { return problem.input_signals.gives(*physics::find_signal(name)); };
    if (gives("slip_ratio") && gives("slip_speed")) {
        errors.add(given.find("slip_speed")->second, "slip_ratio and slip_speed are both given",
                   "keep one: both are the slip along the heading");
    }
    physics::Tire& tire = problem.tire;
    if (!has_tire || !gives("inflation_pressure")) {
        tire.reference_pressure = 0.0;  // which switches the laws' dependence on the pressure off
    }
    if (!has_tire || errors.count() > 0) {  // of what is wrong no range is told
        return;
    }
    const Seen seen = look_at(problem);
    if (tire.reference_pressure > 0.0 && (seen.least_pressure < least_pressure * tire.reference_pressure ||
                                          seen.most_pressure > most_pressure * tire.reference_pressure)) {
        const bool low = seen.least_pressure < least_pressure * tire.reference_pressure;
        errors.warn(given.find("inflation_pressure")->second,
                    "the inflation pressure is {:.4g} kPa, and the tire's laws hold at {:.4g} kPa: how they "
                    "follow the pressure is known from {:.4g} to {:.4g} kPa",
                    1e-3 * (low ? seen.least_pressure : seen.most_pressure), 1e-3 * tire.reference_pressure,
                    1e-3 * least_pressure * tire.reference_pressure, 1e-3 * most_pressure * tire.reference_pressure);
    }
    if (seen.deflection > most_deflection * tire.section_height) {
        const auto load = given.find("vertical_load");
        errors.warn(load != given.end() ? load->second : root.place("drive"),
                    "{:.4g} N at {:.4g} s deflect the tire by {:.1f} mm, {:.0f} % of its section's height: "
                    "the laws of the load know no more than {:.0f} %",
                    seen.load, seen.time, 1e3 * seen.deflection, 100.0 * seen.deflection / tire.section_height,
                    100.0 * most_deflection);
    }
}

}  // namespace tiretherm::input
