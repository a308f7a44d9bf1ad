// SPDX-License-Identifier: BSD-3-Clause
// Converts the three coefficients A, B, C of a law k or c = A T^2 + B T + C into a law of the case.

#include <array>

#include <fmt/format.h>

#include "input/spreadsheet/sheet_body.hpp"
#include "input/text/units.hpp"
#include "input/toml/toml_text.hpp"
#include "physics/curve.hpp"

namespace tiretherm::input {

namespace {

constexpr double zero = 273.15;

/// What stands for the law where the sheet is silent.
struct Standard {
    std::string_view law;
    std::string_view text;
    std::string_view ground;
    std::string_view unit;
};
constexpr std::array standards{
    Standard{"heat_capacity", "\"1800 J/kgK\"", "the thesis's constant, V.1.2", "J/kgK"},
    Standard{"conductivity",
             "{ at = \"20 degC\", value = \"0.29 W/mK\", slope = \"0.00943 W/mK/K\", "
             "range = [\"20 degC\", \"120 degC\"] }",
             "not printed in the thesis: the line through its 0.29 W/mK at 20 degC and 0.95 W/mK at 90 degC", "W/mK"},
};

/// The three coefficients of a law, and the scale on which it counts temperature, as far as the sheet gives them.
struct Given {
    std::array<const SheetValue*, 3> coefficients{};  ///< A, B, C
    std::array<const SheetParameter*, 3> parameters{};
    const SheetValue* scale = nullptr;
    const SheetParameter* scale_parameter = nullptr;
    bool sound = true;
};

Given given(const SheetContent& content, std::string_view law) {
    Given found;
    std::size_t next = 0;
    for (const SheetParameter& parameter : sheet_parameters()) {
        if (parameter.law != law) {
            continue;
        }
        const SheetValue* value = content.find(parameter);
        found.sound = found.sound && (value == nullptr || value->sound);
        if (parameter.use == SheetUse::scale) {
            found.scale = value;
            found.scale_parameter = &parameter;
        } else if (parameter.use == SheetUse::coefficient) {
            found.parameters[next] = &parameter;
            found.coefficients[next++] = value;
        }
    }
    return found;
}

}  // namespace

void add_sheet_law(const SheetContent& content, std::string_view law, SheetBody& body, SheetCase& result,
                   InputErrors& errors) {
    if (table_instead(content, law) != nullptr) {
        return;
    }
    const Standard& standard = law == standards[0].law ? standards[0] : standards[1];
    const Given found = given(content, law);
    const auto& [A, B, C] = found.coefficients;
    SheetBody::Entry entry{.table = "material",
                           .key = std::string(law),
                           .lines = {std::string(standard.text)},
                           .places = {{}},
                           .remark = "assumed",
                           .called = std::string(law)};
    if (!gives_law(content, law) || !found.sound || C == nullptr) {
        if (gives_law(content, law) && C == nullptr) {
            const SheetValue& other = A != nullptr ? *A : *B;
            errors.add(other.name_place, fmt::format("{} is given without coeff. C", other.parameter->name),
                       "give all three, a 0 where there is none");
        } else if (found.sound) {
            result.missing.push_back({fmt::format("material.{}", law), std::string(standard.text),
                                      std::string(standard.ground), std::string(found.parameters[2]->sheet),
                                      "coefficients A, B, C"});
        }
        body.add(std::move(entry));
        return;
    }
    const auto text = [&](std::size_t i, double value) {
        const SheetValue* own = found.coefficients[i];
        return toml_text::quantity(value, own != nullptr ? std::string_view(own->unit) : found.parameters[i]->unit);
    };
    const double a = A != nullptr ? A->number : 0.0;
    const double b = B != nullptr ? B->number : 0.0;
    const bool varies = a != 0.0 || b != 0.0;
    const bool kelvin = found.scale != nullptr && found.scale->text == "K";
    if (varies && found.scale == nullptr) {
        result.missing.push_back({fmt::format("material.{}.at", law), "\"0 degC\"",
                                  "the thesis does not say on which scale: degrees Celsius, as in its other sheets",
                                  std::string(found.scale_parameter->sheet), std::string(found.scale_parameter->name)});
    }
    const std::string base = law == "conductivity" ? "W m-1 K-1" : "J kg-1 K-1";
    const auto si = [&](const SheetValue* value, const std::string& unit) {
        if (value == nullptr) {
            return 0.0;
        }
        const auto known = conversion(value->unit, unit, Scale::difference);
        const auto* to = std::get_if<Conversion>(&known);
        return to != nullptr ? to->to_si(value->number) : value->number;
    };
    const double a_si = si(A, base + " K-2");
    const double b_si = si(B, base + " K-1");
    const double c_si = si(C, base);
    // The thesis's own K1 turns negative below -10.8 degC; where it was measured the range changes nothing.
    const bool is_positive =
        physics::Curve::quadratic_about(kelvin ? 0.0 : zero, c_si, b_si, a_si).minimum(zero - 40.0, zero + 200.0) > 0.0;
    const std::string_view range = is_positive ? std::string_view() : R"(, range = ["20 degC", "120 degC"])";
    if (!kelvin || !varies) {
        entry.lines = {fmt::format("{{ at = \"0 degC\", value = {}, slope = {}, curvature = {}{} }}",
                                   text(2, C->number), text(1, b), text(0, a), range)};
    } else {
        // About 0 degC, which is the same parabola; a law about 0 K would be warned of in every run.
        const std::string per(standard.unit);
        entry.lines = {fmt::format("{{ at = \"0 degC\", value = {}, slope = {}, curvature = {}{} }}",
                                   toml_text::quantity(c_si + zero * (b_si + zero * a_si), per),
                                   toml_text::quantity(b_si + 2.0 * zero * a_si, per + "/K"),
                                   toml_text::quantity(a_si, per + "/K2"), range)};
    }
    entry.places = {C->place};
    entry.remark = fmt::format("{}: coefficients A, B, C", found.parameters[2]->sheet);
    entry.called = fmt::format("the law of {}", found.parameters[2]->sheet);
    body.add(std::move(entry));
    constexpr std::array<std::string_view, 3> keys{"curvature", "slope", "value"};
    for (std::size_t i = 0; i < 3; ++i) {
        const SheetParameter& parameter = *found.parameters[i];
        if (const SheetValue* value = found.coefficients[i]) {
            result.mapped.push_back({std::string(parameter.sheet), std::string(parameter.name),
                                     fmt::format("material.{}.{}", law, keys[i]), fmt::format("{}", value->number),
                                     true, value->number, value->unit});
        } else {
            result.missing.push_back({fmt::format("material.{}.{}", law, keys[i]), text(i, 0.0), "no such term",
                                      std::string(parameter.sheet), std::string(parameter.name)});
        }
    }
    if (found.scale != nullptr) {
        result.mapped.push_back({std::string(found.scale_parameter->sheet), std::string(found.scale_parameter->name),
                                 fmt::format("material.{}.at", law), found.scale->text, false, 0.0, ""});
    }
}

}  // namespace tiretherm::input
