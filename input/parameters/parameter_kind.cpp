// SPDX-License-Identifier: BSD-3-Clause
// The kinds of free parameters, and which of them takes a path or has a parameter.
#include "input/parameters/parameter_kind.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace tiretherm::input {

std::span<const ParameterKind> parameter_kinds() {
    static const std::array kinds{effect_kind(), law_kind(), vehicle_kind(), initial_kind()};
    return kinds;
}

std::optional<FreeParameters> find_parameters(const ParameterPath& path, const CaseAsRead& in, const Knots& knots) {
    const auto kind =
        std::ranges::find_if(parameter_kinds(), [&](const ParameterKind& one) { return one.takes(path); });
    if (kind != parameter_kinds().end()) {
        return kind->find(path, in, knots);
    }
    return in.errors.add(path.keys.front().place, fmt::format("{} is not a number that a fit can free", path.text()),
                         "name a number of [effects], [[source]], [[exchange]], [[camera]], [vehicle] or [initial], "
                         "material.NAME.conductivity, material.NAME.heat_capacity or mesh.link_conductivity");
}

ParameterPath path_of(const solver::Problem& problem, const solver::FreeParameter& parameter) {
    const auto kind =
        std::ranges::find_if(parameter_kinds(), [&](const ParameterKind& one) { return one.has(parameter); });
    return kind->path_of(problem, parameter);
}

LocatedString located(TomlTable& table, std::string_view key, Need need) {
    std::string text = table.text(key, need).value_or("");
    return {std::move(text), table.place(key)};
}

}  // namespace tiretherm::input
