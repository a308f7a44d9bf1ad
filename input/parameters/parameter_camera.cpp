#include <algorithm>

#include <fmt/format.h>

#include "input/parameters/parameter_kinds.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/suggestions.hpp"

namespace tiretherm::input {

namespace {

/// Whether the case's table of a camera has a key, rightly or wrongly written.
bool states(const TomlValue& document, const std::string& camera, const std::string& key) {
    const TomlValue* list = document.find("camera");
    return list != nullptr && std::ranges::any_of(list->items, [&](const TomlValue& table) {
               const TomlValue* name = table.find("name");
               return name != nullptr && name->text == camera && table.find(key) != nullptr;
           });
}

}  // namespace

std::optional<FreeParameters> free_camera(TomlTable& parameter, const ProblemBuilder& builder,
                                          const TomlValue& document) {
    const std::optional<std::string> name = parameter.text("camera");
    const std::optional<std::string> key = parameter.text("key", Need::required);
    if (!name || !key) {
        return std::nullopt;
    }
    if (std::ranges::find(builder.cameras, *name, &Camera::name) == builder.cameras.end()) {
        parameter.add_error("camera", fmt::format("there is no camera \"{}\"", *name),
                            builder.cameras.empty() ? "add [[camera]] with this name"
                                                    : suggest(*name, names_of(builder.cameras), "cameras"));
        return std::nullopt;
    }
    // A camera's numbers are those of the effects that carry its name.
    std::vector<std::string> known;
    for (std::size_t e = 0; e < builder.problem.effects.size(); ++e) {
        const physics::ActiveEffect& active = builder.problem.effects[e];
        if (active.name != *name || active.effect->sensor_model() == nullptr) {
            continue;
        }
        for (std::size_t p = 0; p < active.effect->parameters.size(); ++p) {
            const physics::ParameterSpec& found = active.effect->parameters[p];
            const bool counts = found.key != "reflected_temperature" || active.choices.front() != 0;
            if (counts) {
                known.emplace_back(found.key);
            }
            if (counts && found.key == *key) {
                solver::FreeParameter number;
                number.name = fmt::format("{}.{}", *name, found.key);
                number.unit = found.unit;
                number.kind = solver::FreeParameter::Kind::effect;
                number.effect = e;
                number.parameter = p;
                number.low = found.low;
                number.high = found.high;
                return FreeParameters{.numbers = {std::move(number)}, .spec = quantity_specs::of(found)};
            }
        }
    }
    const bool is_grey = *key == "emissivity" || *key == "reflected_temperature";
    if (builder.has_mesh && !(is_grey && states(document, *name, *key))) {
        parameter.add_error(
            "key",
            is_grey ? fmt::format("the [[camera]] {} does not state {}", *name, *key)
                    : fmt::format("a camera has no number \"{}\"", *key),
            is_grey ? fmt::format("add {} to it: there the search begins",
                                  *key == "emissivity" ? "emissivity = 0.95" : "reflected_temperature = \"23 degC\"")
                    : suggest(*key, known, "numbers"));
    }
    return std::nullopt;
}

}  // namespace tiretherm::input
