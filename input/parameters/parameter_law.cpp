#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "input/parameters/parameter_kinds.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/suggestions.hpp"

namespace tiretherm::input {

namespace {

using solver::FreeParameter;

/// Values of a law may be a hundred times smaller or larger than the case's: a fit shall not get lost.
constexpr double widest = 100.0;

/// The temperatures `at`, whose values are free. Empty after an error.
struct Knots {
    std::vector<double> kelvin;
    std::vector<std::string> written;
};

Knots read_knots(TomlTable& table) {
    const std::size_t before = table.errors().count();
    const std::vector<LocatedString> words = table.texts("at", Need::required);
    Knots knots;
    if (table.has("at") && table.errors().count() == before && (words.empty() || words.size() > 3)) {
        table.add_error("at", fmt::format("at has {} temperatures; a law is free at one, two or three", words.size()),
                        "write at = [\"40 degC\", \"90 degC\", \"140 degC\"]");
        return {};
    }
    for (const LocatedString& word : words) {
        const ParsedQuantity parsed = quantity(word.text, quantity_specs::temperature, "at");
        if (parsed.error) {
            table.errors().add(word.place, *parsed.error);
            continue;
        }
        if (std::find(knots.kelvin.begin(), knots.kelvin.end(), parsed.value) != knots.kelvin.end()) {
            table.errors().add(word.place, "the law is free twice at this temperature", "move or remove one");
        }
        knots.kelvin.push_back(parsed.value);
        knots.written.emplace_back(trim(word.text));
    }
    return table.errors().count() == before ? knots : Knots{};
}

/// The numbers of a law. @param law null where it could not be read
/// @param blank the part that all of them share, its name without the temperature
std::optional<FreeParameters> free_values(TomlTable& table, const physics::Curve* law, const FreeParameter& blank,
                                          const QuantitySpec& spec) {
    FreeParameters freed{.numbers = {}, .spec = spec};
    freed.spec.usual_low = -std::numeric_limits<double>::infinity();  // of a law; a bound may be anywhere
    freed.spec.usual_high = std::numeric_limits<double>::infinity();
    const Knots knots = read_knots(table);
    if (law == nullptr || knots.kelvin.empty()) {
        return std::nullopt;
    }
    if (law->is_table() && knots.kelvin.size() > 1) {
        table.add_error("at", "the law is a table, which can only be scaled",
                        "name one temperature, or write the law through two or three points");
        return std::nullopt;
    }
    for (std::size_t k = 0; k < knots.kelvin.size(); ++k) {
        FreeParameter number = blank;
        const double now = law->value(knots.kelvin[k]);
        if (!(now > 0.0)) {
            table.add_error("at", fmt::format("the case's law is {:.3g} at {}", now, knots.written[k]),
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
std::vector<int> layers_of(const TomlTable& table, const ProblemBuilder& builder, const std::string& material) {
    std::vector<int> layers;
    std::vector<std::string> used;
    for (std::size_t i = 0; i < builder.problem.materials.size(); ++i) {
        const std::string& name = builder.problem.materials[i].name;
        if (name == material) {
            layers.push_back(static_cast<int>(i));
        }
        if (std::find(used.begin(), used.end(), name) == used.end()) {
            used.push_back(name);
        }
    }
    const bool exists = std::any_of(builder.stock.begin(), builder.stock.end(),
                                    [&](const Stock& stock) { return stock.material.name == material; });
    if (layers.empty() && !exists) {
        std::vector<std::string> known;
        for (const Stock& stock : builder.stock) {
            known.push_back(stock.material.name);
        }
        table.add_error("material", fmt::format("there is no material \"{}\"", material),
                        suggest(material, known, "materials"));
    } else if (layers.empty() && builder.has_mesh) {
        table.add_error("material", fmt::format("no layer is made of \"{}\"", material),
                        fmt::format("the layers are made of {}", listed(used)));
    }
    return layers;
}

}  // namespace

std::optional<FreeParameters> free_law(TomlTable& parameter, const ProblemBuilder& builder) {
    constexpr std::array<std::string_view, 2> laws{"conductivity", "heat_capacity"};
    const std::string name = parameter.text("material").value_or("");
    const std::optional<std::size_t> law = parameter.choice("law", laws, Need::required);
    const std::vector<int> layers = layers_of(parameter, builder, name);
    if (!law) {
        read_knots(parameter);
        return std::nullopt;
    }
    const bool conducts = *law == 0;
    const physics::Curve* curve = nullptr;
    if (conducts && builder.problem.mesh.is_lumped()) {
        parameter.add_error("law", "two lumps conduct only through their link", "free that: link = \"conductivity\"");
    } else if (!layers.empty()) {
        const physics::Material& material = builder.problem.materials[static_cast<std::size_t>(layers.front())];
        curve = conducts ? &material.along(mesh::Axis::through) : &material.heat_capacity;
    }
    FreeParameter blank;
    blank.name = fmt::format("{}.{}", name, laws[*law]);
    blank.kind = conducts ? FreeParameter::Kind::conductivity : FreeParameter::Kind::heat_capacity;
    blank.layers = layers;
    return free_values(parameter, curve, blank,
                       conducts ? quantity_specs::conductivity : quantity_specs::heat_capacity);
}

std::optional<FreeParameters> free_link(TomlTable& parameter, const ProblemBuilder& builder) {
    constexpr std::array<std::string_view, 1> laws{"conductivity"};
    const auto law = parameter.choice("link", laws);
    const std::vector<physics::Curve>& links = builder.problem.link_laws;
    if (builder.has_mesh && links.empty()) {
        parameter.add_error("link", "the mesh has no link",
                            "free a material: material = \"...\", law = \"conductivity\"");
    }
    FreeParameter blank;
    blank.name = "link.conductivity";
    blank.kind = FreeParameter::Kind::link_conductivity;
    return free_values(parameter, law && !links.empty() ? &links.front() : nullptr, blank,
                       quantity_specs::conductivity);
}

}  // namespace tiretherm::input
