// SPDX-License-Identifier: BSD-3-Clause
// Computes masses, areas and laws with the model and reports where the measured values of the sheets differ most.

#include "input/spreadsheet/sheet_remarks.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "input/spreadsheet/sheet_body.hpp"
#include "input/text/unit_text.hpp"
#include "input/text/units.hpp"

namespace tiretherm::input {

namespace {

Conversion to_si(std::string_view unit, std::string_view wanted) {
    return std::get<Conversion>(conversion(unit, spelt_out(wanted), Scale::absolute));
}

/// What the program makes of a number that follows from others. In the parameter's unit
double computed_value(std::string_view name, const solver::Problem& problem) {
    const physics::Tire& tire = problem.tire;
    const auto mass = [&](std::size_t cell) { return problem.mesh.volume[cell] * problem.materials[cell].density; };
    if (name == "Surface Mass") {
        return mass(0);
    }
    if (name == "Bulk Mass") {
        return mass(1);
    }
    if (name == "Area Ratio") {
        return tire.area_ratio();
    }
    if (name == "Characteristic Length") {
        return 1.0 / (1.0 / (2.0 * tire.unloaded_radius) + 1.0 / tire.width);
    }
    return tire.outer_area();
}

/// A law's value where a table was measured. @param x, T in SI
double modelled(const SheetTable& table, double x, double T, const solver::Problem& problem) {
    const physics::Tire& tire = problem.tire;
    if (table.key == "contact_length") {
        return tire.contact_length(x);
    }
    if (table.key == "contact_area") {
        return tire.contact_area(x);
    }
    if (table.key == "loaded_radius") {
        return tire.loaded_radius(x);
    }
    if (table.key == "rolling_radius") {
        return tire.rolling_radius(x);
    }
    if (table.key == "conductivity") {
        return problem.materials[0].along(mesh::Axis::through).value(x);
    }
    if (table.key == "heat_capacity") {
        return problem.materials[0].heat_capacity.value(x);
    }
    return problem.handling.lambda_CP * physics::cornering_stiffness(problem.handling.modulus, tire, x, T).value;
}

/// A measured table beside the model: where they are furthest apart.
std::string comparison(const SheetMeasured& measured, const solver::Problem& problem) {
    const SheetTable& table = *measured.table;
    const bool temperature = table.variable_unit == "degC";
    const std::string_view variable = temperature ? "K" : table.variable_unit;
    const Conversion x = to_si(measured.variable_unit, variable);
    const Conversion y = to_si(measured.value_unit, table.value_unit);
    const Conversion si_of_unit = to_si(table.value_unit, table.value_unit == "mm"    ? "m"
                                                          : table.value_unit == "mm2" ? "m2"
                                                                                      : table.value_unit);
    std::size_t worst = 0;
    double apart = -1.0;
    for (std::size_t i = 0; i < measured.value.size(); ++i) {
        const double T =
            table.also_temperature ? to_si(measured.temperature_unit, "K").to_si(measured.temperature[i]) : 0.0;
        const double model = modelled(table, x.to_si(measured.variable[i]), T, problem) / si_of_unit.factor;
        const double relative = model / y.to_si(measured.value[i]) - 1.0;
        if (std::abs(relative) > apart || std::isnan(relative)) {
            apart = std::abs(relative);
            worst = i;
        }
    }
    const double T =
        table.also_temperature ? to_si(measured.temperature_unit, "K").to_si(measured.temperature[worst]) : 0.0;
    const double model = y.from_si(modelled(table, x.to_si(measured.variable[worst]), T, problem) / si_of_unit.factor);
    return fmt::format("furthest off at {:.6g} {}{}: measured {:.4g} {}, law {:.4g} {}", measured.variable[worst],
                       measured.variable_unit,
                       table.also_temperature
                           ? fmt::format(", {:.6g} {}", measured.temperature[worst], measured.temperature_unit)
                           : "",
                       measured.value[worst], measured.value_unit, model, measured.value_unit);
}

}  // namespace

void compare_with_sheet(const SheetContent& content, const solver::Problem& problem, SheetCase& result) {
    for (const SheetValue& value : content.values) {
        const SheetParameter& parameter = *value.parameter;
        if (parameter.use != SheetUse::computed) {
            continue;
        }
        const std::string_view unit = parameter.unit == "1" ? "" : parameter.unit;
        const double ours = computed_value(parameter.name, problem);
        const double theirs = to_si(value.unit, parameter.unit).to_si(value.number);
        const double apart = 100.0 * (theirs / ours - 1.0);
        std::string reason = fmt::format("computed by the program: {:.5g}{}{}", ours, unit.empty() ? "" : " ", unit);
        reason += std::abs(apart) < 0.05 ? ", as in the sheet"
                                         : fmt::format("; that of the sheet is {:+.2g} % off and not used", apart);
        result.unmapped.push_back({std::string(parameter.sheet), std::string(parameter.name),
                                   value.unit == "1" ? value.text : fmt::format("{} {}", value.number, value.unit),
                                   std::move(reason)});
    }
    for (const SheetMeasured& measured : content.measured) {
        const SheetTable& table = *measured.table;
        if (!table.key.empty() && table_instead(content, table.law) == &measured) {
            continue;
        }
        const std::string_view why = table.also_temperature ? "the program makes the cornering stiffness of the modulus"
                                                            : "the law of the same sheet is used";
        result.unmapped.push_back({std::string(table.sheet), fmt::format("{} against {}", table.value, table.variable),
                                   fmt::format("{} rows", measured.value.size()),
                                   fmt::format("{}; {}", why, comparison(measured, problem))});
    }
}

}  // namespace tiretherm::input
