// SPDX-License-Identifier: BSD-3-Clause
// Paths of laws k(T) and c(T), which are free by their values at one to three temperatures.
#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "input/parameters/resolve.hpp"
#include "input/text/characters.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"

namespace tiretherm::input {

namespace {

using solver::FreeParameter;

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
        in.errors.add(knots.place, "the law is a table, which can only be scaled",
                      "name one temperature, or write the law through two or three points");
        return std::nullopt;
    }
    for (std::size_t k = 0; k < knots.kelvin.size(); ++k) {
        const double T = knots.kelvin[k];
        if (const auto range = law->range(); range && (T < (*range)[0] || T > (*range)[1])) {
            in.errors.add(knots.place,
                          fmt::format("the case's law is held outside {:.6g} to {:.6g} degC, and {} lies there",
                                      (*range)[0] - 273.15, (*range)[1] - 273.15, knots.written[k]),
                          "name a temperature inside the law's range");
            return std::nullopt;
        }
        FreeParameter number = blank;
        const double now = law->value(knots.kelvin[k]);
        if (!(now > 0.0)) {
            in.errors.add(knots.place, fmt::format("the case's law is {:.3g} at {}", now, knots.written[k]),
                          "name a temperature where it is positive");
            return std::nullopt;
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
    std::vector<std::string> known;
    for (const Stock& stock : in.stock) {
        known.push_back(stock.material.name);
    }
    const bool exists = std::ranges::find(known, material.text) != known.end();
    if (layers.empty() && !exists) {
        in.errors.add(material.place, fmt::format("there is no material \"{}\"", material.text),
                      suggest(material.text, known, "materials"));
    } else if (layers.empty() && in.problem.mesh.n_nodes > 0) {
        in.errors.add(material.place, fmt::format("no layer is made of \"{}\"", material.text),
                      fmt::format("the layers are made of {}", listed(used)));
    }
    return layers;
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
        const ParsedQuantity parsed = parse_quantity(word.text, quantity_specs::temperature, "at");
        if (parsed.error) {
            table.errors().add(word.place, *parsed.error);
            continue;
        }
        if (std::ranges::find(knots.kelvin, parsed.value) != knots.kelvin.end()) {
            table.errors().add(word.place, "the law is free twice at this temperature", "move or remove one");
        }
        knots.kelvin.push_back(parsed.value);
        knots.written.emplace_back(trim(word.text));
    }
    return table.errors().count() == before ? knots : Knots{};
}

namespace {

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

}  // namespace

std::optional<FreeParameters> resolve_material(const ParameterPath& path, const CaseAsRead& in, const Knots& knots) {
    const LocatedString& name = path.keys[1];
    const LocatedString& law = path.keys[2];
    FreeParameter blank;
    blank.name = fmt::format("{}.{}", name.text, law.text);
    blank.layers = layers_of(in, name);
    if (law.text == "conductivity" && in.problem.mesh.n_nodes > 0 && in.problem.mesh.is_lumped()) {
        in.errors.add(law.place, "two lumps conduct only through their link", "free that: link = \"conductivity\"");
        return std::nullopt;
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

std::optional<FreeParameters> resolve_link(const ParameterPath& path, const CaseAsRead& in, const Knots& knots) {
    if (in.problem.mesh.n_nodes > 0 && in.problem.link_laws.empty()) {
        in.errors.add(path.keys.back().place, "the mesh has no link",
                      "free a material: material = \"...\", law = \"conductivity\"");
    }
    FreeParameter blank;
    blank.name = "link.conductivity";
    blank.kind = FreeParameter::Kind::link_conductivity;
    return free_values(in, knots, blank, quantity_specs::conductivity);
}

}  // namespace tiretherm::input
