// SPDX-License-Identifier: BSD-3-Clause
// What a case calls effects, their parameters and the places where these may differ.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "physics/effect.hpp"
#include "solver/problem.hpp"

namespace tiretherm::input {

/// The ending of a key whose values differ from place to place: "_by_patch" of "h_by_patch".
[[nodiscard]] std::string key_ending(physics::Scope scope);
/// All places of a kind, in the order of their indices. Of channels those of cameras as well, behind the sensors.
[[nodiscard]] std::vector<std::string> place_names(const solver::Problem& problem, physics::Scope scope);

/// What a case calls a channel: by its own name, or by its camera's. @param channel index into Problem::channels
[[nodiscard]] std::string sensor_of(const solver::Problem& problem, int channel);

/// An effect of the catalogue or one number of it, as `[diagnose] candidates` names it: "radiation",
/// "sliding_friction.partition"; or by its path, "effects.sliding_friction.partition".
struct CatalogueEntry {
    const physics::Effect* effect = nullptr;
    std::optional<std::size_t> parameter{};  ///< all numbers of the effect where it is empty

    [[nodiscard]] bool includes(const physics::Effect& other, std::size_t number) const {
        return effect == &other && parameter.value_or(number) == number;
    }
    [[nodiscard]] std::string text() const;
};
/// @returns nothing where the catalogue has no such effect or number
[[nodiscard]] std::optional<CatalogueEntry> find_in_catalogue(std::string_view text);

}  // namespace tiretherm::input
