// SPDX-License-Identifier: BSD-3-Clause
// The numbers of [vehicle] as free parameters: "vehicle.mass".
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "input/effects/user_effects.hpp"
#include "input/parameters/parameter_kind.hpp"
#include "input/schema/all_tables.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"
#include "input/toml/toml_text.hpp"
#include "input/vehicle/vehicle_numbers.hpp"

namespace tiretherm::input {

namespace {

/// Above zero a number needs room: a car of no mass has no load, and its centre of gravity lies between the axles.
constexpr double least_share = 0.01;

/// The name of a run that gives the number a value of its own, or its place in the list; empty where none does.
std::string owner_of(const TomlValue& document, const std::string& key) {
    const TomlValue* runs = document.find("run");
    for (std::size_t i = 0; runs != nullptr && i < runs->items.size(); ++i) {
        const TomlValue& run = runs->items[i];
        const TomlValue* own = run.kind == TomlValue::Kind::table ? run.find("vehicle") : nullptr;
        if (own != nullptr && own->find(key) != nullptr) {
            const TomlValue* name = run.find("name");
            return name != nullptr ? name->text : fmt::format("{}", i + 1);
        }
    }
    return {};
}

/// Formulas of the case take the inputs as they are: they would not see the car change.
void refuse_followers(const CaseAsRead& in, const LocatedString& key) {
    const std::vector<std::string> followed = followed_names(in.document);
    for (const physics::Signal* signal : in.problem.input_model->signals()) {
        // The tire's speed is the car's, but for the half of a track in a turn.
        const bool follows_it = signal->name != "speed" || key.text.ends_with("track");
        if (follows_it && std::ranges::find(followed, signal->name) != followed.end()) {
            in.errors.add(
                key.place,
                fmt::format("a [[source]] or an [[exchange]] follows {}, which follows {}; in a fit it would not",
                            signal->name, key.text),
                "let it follow what is measured, or remove this [[parameter]]");
            return;
        }
    }
}

std::optional<FreeParameters> find_vehicle_number(const ParameterPath& path, const CaseAsRead& in,
                                                  const Knots& /*knots*/) {
    const LocatedString& key = path.keys.back();
    if (in.document.find("vehicle") == nullptr) {
        return in.errors.add(path.keys.front().place, "the case has no [vehicle]", "remove this [[parameter]]");
    }
    const std::vector<std::string> known = names_of(vehicle_numbers(), &VehicleNumberSpec::key);
    const auto found = std::ranges::find(known, key.text);
    if (path.keys.size() > 2 || found == known.end()) {
        return in.errors.add(key.place, fmt::format("[vehicle] has no number \"{}\" to fit", key.text),
                             suggest(key.text, known, "numbers"));
    }
    const auto index = static_cast<std::size_t>(found - known.begin());
    if (in.problem.input_numbers.empty()) {
        return std::nullopt;  // the log or the table is wrong, which has been reported
    }
    const QuantitySpec& spec = keys_of_table("vehicle")->find(key.text)->spec;
    const double value = in.problem.input_numbers[index];
    if (std::isnan(value) || path.find(in.document) == nullptr) {
        return in.errors.add(key.place, fmt::format("[vehicle] does not give {}", key.text),
                             fmt::format("add {} to it: there the search begins", key.text));
    }
    if (const std::string owner = owner_of(in.document, key.text); !owner.empty()) {
        return in.errors.add(key.place, fmt::format("run {} has a {} of its own", owner, key.text),
                             "a fit moves the one of [vehicle]: remove it from the run");
    }
    refuse_followers(in, key);
    solver::FreeParameter number;
    number.name = fmt::format("vehicle.{}", key.text);
    number.unit = spec.unit;
    number.kind = solver::FreeParameter::Kind::input;
    number.parameter = index;
    number.low = spec.above ? std::max(spec.low, least_share * value) : spec.low;
    number.high = spec.high;
    if (index == static_cast<std::size_t>(VehicleNumber::front_weight_share)) {
        number.low = least_share;
        number.high = 1.0 - least_share;
    }
    if (index == static_cast<std::size_t>(VehicleNumber::centre_of_gravity_behind_front_axle)) {
        const VehicleNumbers all(in.problem.input_numbers);
        number.low = least_share * all[VehicleNumber::wheelbase];
        number.high = (1.0 - least_share) * all[VehicleNumber::wheelbase];
    }
    return FreeParameters{.numbers = {std::move(number)}, .spec = spec};
}

ParameterPath path_of_vehicle_number(const solver::Problem& /*problem*/, const solver::FreeParameter& number) {
    return ParameterPath::of({"vehicle", vehicle_numbers()[number.parameter].key});
}

bool is_vehicle_number(const solver::FreeParameter& parameter) {
    return parameter.kind == solver::FreeParameter::Kind::input;
}

void write_vehicle(TomlValue& over, const Overlay& overlay, const TomlValue& /*original*/) {
    for (const solver::FreeParameter& number : overlay.parameters) {
        if (is_vehicle_number(number)) {
            path_of_vehicle_number(*overlay.fitted, number)
                .put(over, toml_text::quantity_value(overlay.fitted->input_numbers[number.parameter], number.unit));
        }
    }
}

}  // namespace

ParameterKind vehicle_kind() {
    return {.subjects = {},
            .takes = [](const ParameterPath& path) { return path.keys.front().text == "vehicle"; },
            .has = is_vehicle_number,
            .paths_of_table = nullptr,
            .find = find_vehicle_number,
            .path_of = path_of_vehicle_number,
            .write = write_vehicle};
}

}  // namespace tiretherm::input
