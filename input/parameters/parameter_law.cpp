#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "input/parameters/parameter_kinds.hpp"
#include "input/text/wanted.hpp"
#include "input/text/words.hpp"

namespace tiretherm::input {

namespace {

using solver::Adjustable;

/// Values of a law may be a hundred times smaller or larger than the case's: a fit shall not get lost.
constexpr double widest = 100.0;

/// The temperatures `at`, whose values are free. Empty after a mistake.
struct Knots {
    std::vector<double> kelvin;
    std::vector<std::string> written;
};

Knots read_knots(Section& section) {
    const std::size_t before = section.mistakes().count();
    const std::vector<Word> words = section.texts("at", Need::required);
    Knots knots;
    if (section.has("at") && section.mistakes().count() == before && (words.empty() || words.size() > 3)) {
        section.mistake("at", fmt::format("at has {} temperatures; a law is free at one, two or three", words.size()),
                        "write at = [\"40 degC\", \"90 degC\", \"140 degC\"]");
        return {};
    }
    for (const Word& word : words) {
        const Judged judged = quantity(word.text, wanted::temperature, "at");
        if (judged.fault) {
            section.mistakes().add(word.place, *judged.fault);
            continue;
        }
        if (std::find(knots.kelvin.begin(), knots.kelvin.end(), judged.value) != knots.kelvin.end()) {
            section.mistakes().add(word.place, "the law is free twice at this temperature", "move or remove one");
        }
        knots.kelvin.push_back(judged.value);
        knots.written.emplace_back(trim(word.text));
    }
    return section.mistakes().count() == before ? knots : Knots{};
}

/// The numbers of a law. @param law null where it could not be read
/// @param blank the part that all of them share, its name without the temperature
std::optional<Freed> free_values(Section& section, const physics::Curve* law, const Adjustable& blank,
                                 const Wanted& wanted) {
    Freed freed{.numbers = {}, .wanted = wanted};
    freed.wanted.usual_low = -std::numeric_limits<double>::infinity();  // of a law; a bound may be anywhere
    freed.wanted.usual_high = std::numeric_limits<double>::infinity();
    const Knots knots = read_knots(section);
    if (law == nullptr || knots.kelvin.empty()) {
        return std::nullopt;
    }
    if (law->is_table() && knots.kelvin.size() > 1) {
        section.mistake("at", "the law is a table, which can only be scaled",
                        "name one temperature, or write the law through two or three points");
        return std::nullopt;
    }
    for (std::size_t k = 0; k < knots.kelvin.size(); ++k) {
        Adjustable number = blank;
        const double now = law->value(knots.kelvin[k]);
        if (!(now > 0.0)) {
            section.mistake("at", fmt::format("the case's law is {:.3g} at {}", now, knots.written[k]),
                            "name a temperature where it is positive");
            return std::nullopt;
        }
        number.name += " at " + knots.written[k];
        number.unit = wanted.unit;
        number.knots = knots.kelvin;
        number.knot = k;
        number.low = now / widest;
        number.high = now * widest;
        freed.numbers.push_back(std::move(number));
    }
    return freed;
}

/// Layers that are made of a material, or a mistake.
std::vector<int> layers_of(const Section& section, const Draft& draft, const std::string& material) {
    std::vector<int> layers;
    std::vector<std::string> used;
    for (std::size_t i = 0; i < draft.problem.materials.size(); ++i) {
        const std::string& name = draft.problem.materials[i].name;
        if (name == material) {
            layers.push_back(static_cast<int>(i));
        }
        if (std::find(used.begin(), used.end(), name) == used.end()) {
            used.push_back(name);
        }
    }
    const bool exists = std::any_of(draft.stock.begin(), draft.stock.end(),
                                    [&](const Stock& stock) { return stock.material.name == material; });
    if (layers.empty() && !exists) {
        std::vector<std::string> known;
        for (const Stock& stock : draft.stock) {
            known.push_back(stock.material.name);
        }
        section.mistake("material", fmt::format("there is no material \"{}\"", material),
                        suggest(material, known, "materials"));
    } else if (layers.empty() && draft.has_mesh) {
        section.mistake("material", fmt::format("no layer is made of \"{}\"", material),
                        fmt::format("the layers are made of {}", listed(used)));
    }
    return layers;
}

}  // namespace

std::optional<Freed> free_law(Section& parameter, const Draft& draft) {
    constexpr std::array<std::string_view, 2> laws{"conductivity", "heat_capacity"};
    const std::string name = parameter.text("material").value_or("");
    const std::optional<std::size_t> law = parameter.choice("law", laws, Need::required);
    const std::vector<int> layers = layers_of(parameter, draft, name);
    if (!law) {
        read_knots(parameter);
        return std::nullopt;
    }
    const bool conducts = *law == 0;
    const physics::Curve* curve = nullptr;
    if (conducts && draft.problem.mesh.kind == "two_node") {
        parameter.mistake("law", "two lumps conduct only through their link", "free that: link = \"conductivity\"");
    } else if (!layers.empty()) {
        const physics::Material& material = draft.problem.materials[static_cast<std::size_t>(layers.front())];
        curve = conducts ? &material.along(mesh::Axis::through) : &material.heat_capacity;
    }
    Adjustable blank;
    blank.name = fmt::format("{}.{}", name, laws[*law]);
    blank.kind = conducts ? Adjustable::Kind::conductivity : Adjustable::Kind::heat_capacity;
    blank.layers = layers;
    return free_values(parameter, curve, blank, conducts ? wanted::conductivity : wanted::heat_capacity);
}

std::optional<Freed> free_link(Section& parameter, const Draft& draft) {
    constexpr std::array<std::string_view, 1> laws{"conductivity"};
    const auto law = parameter.choice("link", laws);
    const std::vector<physics::Curve>& links = draft.problem.link_laws;
    if (draft.has_mesh && links.empty()) {
        parameter.mistake("link", "the mesh has no link",
                          "free a material: material = \"...\", law = \"conductivity\"");
    }
    Adjustable blank;
    blank.name = "link.conductivity";
    blank.kind = Adjustable::Kind::link_conductivity;
    return free_values(parameter, law && !links.empty() ? &links.front() : nullptr, blank, wanted::conductivity);
}

}  // namespace tiretherm::input
