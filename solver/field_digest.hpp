// SPDX-License-Identifier: BSD-3-Clause
// Hashes a value with all that it is made of: numbers, texts, lists, what is pointed at, and all members of structs.
#pragma once

#include <bit>
#include <cstddef>
#include <initializer_list>
#include <ranges>
#include <string_view>
#include <type_traits>

#include "physics/effect.hpp"
#include "physics/tire_laws/magic_formula.hpp"
#include "solver/digest.hpp"
#include "solver/members.hpp"

namespace tiretherm::solver {

/// Adds all that a value is made of. A class with private members names them in `visit_members`; whatever adds itself does so.
/// Effects and signals count by their names, for they are those of the program.
template <typename Value>
void add_fields(Digest& digest, const Value& value) {
    const auto add = [&digest](const auto& member) { add_fields(digest, member); };
    if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>) {
        digest.add(value);
    } else if constexpr (std::is_convertible_v<Value, std::string_view>) {
        digest.add(std::string_view(value));
    } else if constexpr (std::is_member_object_pointer_v<Value>) {
        digest.add(std::bit_cast<std::ptrdiff_t>(value));
    } else if constexpr (std::is_same_v<Value, const physics::Effect*>) {
        digest.add(value->id);
    } else if constexpr (std::is_same_v<Value, const physics::Signal*>) {
        digest.add(value->name);
    } else if constexpr (std::is_same_v<Value, physics::MagicFormula>) {
        // What thermal runs look at of it; all of it stands in the file, whose bytes belong to the identity of the call.
        for (const double coefficient : {value.nominal_load, value.pKy1, value.pDy1, value.pKx1, value.pDx1}) {
            digest.add(coefficient);
        }
    } else if constexpr (requires { value.add_to(digest); }) {
        value.add_to(digest);
    } else if constexpr (requires { value.visit_members(add); }) {
        value.visit_members(add);
    } else if constexpr (requires { *value; }) {  // an optional or a pointer
        digest.add(static_cast<bool>(value));
        if (value) {
            add(*value);
        }
    } else if constexpr (std::ranges::range<Value>) {
        digest.add(static_cast<std::size_t>(std::ranges::distance(value)));
        for (const auto& item : value) {
            add(item);
        }
    } else {
        for_each_member(value, add);
    }
}

}  // namespace tiretherm::solver
