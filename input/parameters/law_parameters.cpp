// SPDX-License-Identifier: BSD-3-Clause
// Laws k(T) and c(T) as free parameters, by their values at one to three temperatures.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "input/parameters/parameter_kind.hpp"
#include "input/text/characters.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/word_lists.hpp"
#include "input/toml/toml_text.hpp"
#include "physics/celsius.hpp"

namespace tiretherm::input {

namespace {

using solver::FreeParameter;
using toml_text::list_value;
using toml_text::quantity_value;
using toml_text::table_value;
using toml_text::temperature_value;
using toml_text::texts_value;

/// Values of a law may be a hundred times smaller or larger than the case's: a fit shall not get lost.
constexpr double widest = 100.0;

/// The numbers of a law. @param blank the part that all of them share, its name without the temperature
std::optional<FreeParameters> free_values(const CaseAsRead& in, const Knots& knots, const FreeParameter& blank,
                                          const QuantitySpec& spec) {
    FreeParameters freed{.numbers = {}, .spec = spec};
    const physics::Curve* law = solver::law_of(in.problem, blank);
    freed.spec.usual_low = -std::numeric_limits<double>::infinity();  // of a law; a bound may be anywhere
    freed.spec.usual_high = std::numeric_limits<double>::infinity();
    if (law == nullptr || knots.kelvin.empty()) {
        return std::nullopt;
    }
    if (law->is_table() && knots.kelvin.size() > 1) {
        return in.errors.add(knots.place, "the law is a table, which can only be scaled",
                             "name one temperature, or write the law through two or three points");
    }
    for (std::size_t k = 0; k < knots.kelvin.size(); ++k) {
        const double T = knots.kelvin[k];
        if (const auto range = law->range(); range && (T < (*range)[0] || T > (*range)[1])) {
            return in.errors.add(knots.place,
                                 fmt::format("the case's law is held outside {:.6g} to {:.6g} degC, and {} lies there",
                                             celsius((*range)[0]), celsius((*range)[1]), knots.written[k]),
                                 "name a temperature inside the law's range");
        }
        FreeParameter number = blank;
        const double now = law->value(knots.kelvin[k]);
        if (!(now > 0.0)) {
            return in.errors.add(knots.place, fmt::format("the case's law is {:.3g} at {}", now, knots.written[k]),
                                 "name a temperature where it is positive");
        }
        number.name += " at " + knots.written[k];
        number.unit = spec.unit;
        number.knots = knots.kelvin;
        number.knot = k;
        number.low = now / widest;
        number.high = now * widest;
        freed.numbers.push_back(std::move(number));
    }
    return freed;
}

/// Layers that are made of a material, or an error.
std::vector<int> layers_of(const CaseAsRead& in, const LocatedString& material) {
    std::vector<int> layers;
    std::vector<std::string> used;
    for (std::size_t i = 0; i < in.problem.materials.size(); ++i) {
        const std::string& name = in.problem.materials[i].name;
        if (name == material.text) {
            layers.push_back(static_cast<int>(i));
        }
        if (std::ranges::find(used, name) == used.end()) {
            used.push_back(name);
        }
    }
    if (layers.empty() &&
        find_name(material, names_of_materials(in.stock), "there is no material", "materials", in.errors) &&
        in.problem.mesh.n_nodes > 0) {
        in.errors.add(material.place, fmt::format("no layer is made of \"{}\"", material.text),
                      fmt::format("the layers are made of {}", listed(used)));
    }
    return layers;
}

/// What follows from cords and rubber is not free by itself, and would not follow a rubber that a fit changes.
/// @returns false after an error
bool may_be_free(const CaseAsRead& in, const LocatedString& name, const LocatedString& law) {
    for (const Stock& stock : in.stock) {
        if (!stock.ply) {
            continue;
        }
        const bool follows = law.text == "conductivity" || stock.ply->capacity;
        if (stock.material.name == name.text && follows) {
            in.errors.add(law.place, fmt::format("the {} of {} follows from its cords and rubber", law.text, name.text),
                          law.text == "conductivity"
                              ? "free a factor on it: effect = \"layer_conductivity\", key = \"scale\""
                              : "give the material a density and a heat_capacity of its own");
            return false;
        }
        if (stock.ply->rubber == name.text && follows && stock.used) {
            in.errors.add(law.place,
                          fmt::format("the {} of {} is also in the plies of {}, which would not follow it in a fit",
                                      law.text, name.text, stock.material.name),
                          "name another material, with the same numbers, as the rubber of the plies");
            return false;
        }
    }
    return true;
}

std::optional<FreeParameters> find_material_law(const ParameterPath& path, const CaseAsRead& in, const Knots& knots) {
    const LocatedString& name = path.keys[1];
    const LocatedString& law = path.keys[2];
    FreeParameter blank;
    blank.name = fmt::format("{}.{}", name.text, law.text);
    blank.layers = layers_of(in, name);
    if (law.text == "conductivity" && in.problem.mesh.n_nodes > 0 && in.problem.mesh.is_lumped()) {
        return in.errors.add(law.place, "two lumps conduct only through their link",
                             "free that: link = \"conductivity\"");
    }
    if (law.text.empty() || blank.layers.empty()) {
        return std::nullopt;
    }
    if (!may_be_free(in, name, law)) {
        return std::nullopt;
    }
    const bool conducts = law.text == "conductivity";
    blank.kind = conducts ? FreeParameter::Kind::conductivity : FreeParameter::Kind::heat_capacity;
    return free_values(in, knots, blank, conducts ? quantity_specs::conductivity : quantity_specs::heat_capacity);
}

std::optional<FreeParameters> find_link_law(const ParameterPath& path, const CaseAsRead& in, const Knots& knots) {
    if (in.problem.mesh.n_nodes > 0 && in.problem.link_laws.empty()) {
        in.errors.add(path.keys.back().place, "the mesh has no link",
                      "free a material: material = \"...\", law = \"conductivity\"");
    }
    FreeParameter blank;
    blank.name = "link.conductivity";
    blank.kind = FreeParameter::Kind::link_conductivity;
    return free_values(in, knots, blank, quantity_specs::conductivity);
}

std::optional<FreeParameters> find_law(const ParameterPath& path, const CaseAsRead& in, const Knots& knots) {
    return path.keys.front().text == "mesh" ? find_link_law(path, in, knots) : find_material_law(path, in, knots);
}

std::vector<ParameterPath> paths_of_law(TomlTable& table, std::string_view subject, const TomlValue& /*document*/) {
    const SourceLocation place = table.place(subject);
    if (subject == "material") {
        const LocatedString name = located(table, "material");
        const std::string law(table.word("law").value_or(""));
        return {ParameterPath{.keys = {{"material", place}, name, {law, table.place("law")}}}};
    }
    if (!table.choice("link")) {
        return {};
    }
    return {ParameterPath{.keys = {{"mesh", place}, {"link_conductivity", place}}}};
}

ParameterPath path_of_law(const solver::Problem& problem, const FreeParameter& number) {
    if (number.kind == FreeParameter::Kind::link_conductivity) {
        return ParameterPath::of({"mesh", "link_conductivity"});
    }
    return ParameterPath::of({"material", problem.materials[static_cast<std::size_t>(number.layers.front())].name,
                              number.kind == FreeParameter::Kind::conductivity ? "conductivity" : "heat_capacity"});
}

/// A law's value as it was fitted: evaluating the law has left a few units in the last place.
double tidy(double value) {
    const double twelve_digits = std::stod(fmt::format("{:.12g}", value));
    return std::abs(twelve_digits - value) <= 1e-14 * std::abs(value) ? twelve_digits : value;
}

/// Adds the range beyond which a law is held.
TomlValue with_range(TomlValue law_table, const physics::Curve& law) {
    if (const auto range = law.range()) {
        law_table.set("range", list_value({temperature_value((*range)[0]), temperature_value((*range)[1])}));
    }
    return law_table;
}

/// A law in the form that gives it back: through the temperatures at which it was fitted where they make it up, about
/// one of them otherwise; a table as its points.
TomlValue law_value(const physics::Curve& law, const std::vector<double>& knots, const std::string& unit) {
    const auto point = [&](double T) {
        return list_value({temperature_value(T), quantity_value(tidy(law.value(T)), unit)});
    };
    if (law.is_table()) {
        std::vector<TomlValue> rows;
        for (std::size_t i = 0; i < law.table_x().size(); ++i) {
            rows.push_back(list_value({quantity_value(law.table_x()[i], "1"), quantity_value(law.table_y()[i], "1")}));
        }
        return table_value({{"columns", texts_value({"temperature [K]", fmt::format("value [{}]", unit)})},
                            {"rows", list_value(std::move(rows))}});
    }
    if (law.is_constant()) {
        return quantity_value(law.value(0.0), unit);
    }
    const double curvature = law.coefficients()[2];
    if (knots.size() == 3 || (knots.size() == 2 && curvature == 0.0)) {
        std::vector<TomlValue> points;
        std::ranges::transform(knots, std::back_inserter(points), point);
        return with_range(table_value({{"through", list_value(std::move(points))}}), law);
    }
    const double T = knots.front();
    TomlValue about = table_value({{"at", temperature_value(T)},
                                   {"value", quantity_value(tidy(law.value(T)), unit)},
                                   {"slope", quantity_value(law.slope(T), unit + "/K")}});
    if (curvature != 0.0) {
        about.set("curvature", quantity_value(curvature, unit + "/K2"));
    }
    return with_range(std::move(about), law);
}

/// The laws that were fitted: of the link first, then of materials.
void write_laws(TomlValue& over, const Overlay& overlay, const TomlValue& original) {
    using Kind = FreeParameter::Kind;
    for (const Kind kind : {Kind::link_conductivity, Kind::conductivity, Kind::heat_capacity}) {
        for (const solver::FreeParameter& number : overlay.parameters) {
            if (number.kind != kind) {
                continue;
            }
            const physics::Curve& fitted_law = *solver::law_of(*overlay.fitted, number);
            const TomlValue law = law_value(fitted_law, number.knots, kind == Kind::heat_capacity ? "J/kgK" : "W/mK");
            ParameterPath path = path_of_law(*overlay.fitted, number);
            path.put(over, law);
            if (kind != Kind::conductivity) {
                continue;
            }
            // What the case does not give follows by itself.
            const physics::Material& material =
                overlay.fitted->materials[static_cast<std::size_t>(number.layers.front())];
            for (const auto& [key, axis] : {std::pair{"conductivity_circumference", mesh::Axis::circumference},
                                            std::pair{"conductivity_meridian", mesh::Axis::meridian}}) {
                path.keys.back().text = key;
                if (material.along(axis) == fitted_law && path.find(original) != nullptr) {
                    path.put(over, law);
                }
            }
        }
    }
    if (TomlValue* materials = over.find("material")) {  // whatever the order of the numbers
        std::ranges::sort(materials->items, {},
                          [](const TomlValue& material) { return material.entries.front().value.text; });
    }
}

}  // namespace

Knots read_knots(TomlTable& table) {
    const std::size_t before = table.errors().count();
    const std::vector<LocatedString> words = table.texts("at", Need::required);
    Knots knots{.place = table.place("at")};
    if (table.has("at") && table.errors().count() == before && (words.empty() || words.size() > 3)) {
        table.add_error("at", fmt::format("at has {} temperatures; a law is free at one, two or three", words.size()),
                        "write at = [\"40 degC\", \"90 degC\", \"140 degC\"]");
        return {};
    }
    for (const LocatedString& word : words) {
        const auto kelvin = read_quantity(word, quantity_specs::temperature, "at", table.errors());
        if (kelvin && std::ranges::find(knots.kelvin, *kelvin) != knots.kelvin.end()) {
            table.errors().add(word.place, "the law is free twice at this temperature", "move or remove one");
        }
        knots.kelvin.push_back(kelvin.value_or(0.0));
        knots.written.emplace_back(trim(word.text));
    }
    return table.errors().count() == before ? knots : Knots{};
}

ParameterKind law_kind() {
    return {.subjects = {"material", "link"},
            .takes =
                [](const ParameterPath& path) {
                    return path.is_law() || (path.keys.front().text == "material" && path.keys.back().text.empty());
                },
            .has = [](const FreeParameter& parameter) { return !parameter.knots.empty(); },
            .paths_of_table = paths_of_law,
            .find = find_law,
            .path_of = path_of_law,
            .write = write_laws};
}

}  // namespace tiretherm::input
