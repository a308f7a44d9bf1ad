// SPDX-License-Identifier: BSD-3-Clause
// The Magic Formula leans with the camber where there is any; everything else reads what it needs.

#include "solver/quantity_inputs.hpp"

#include <array>

namespace tiretherm::solver {

namespace {
constexpr std::array<std::string_view, 1> leaning{"camber"};
}

std::span<const std::string_view> optional_signals(Quantity quantity) {
    return description_of(quantity).needs_magic_formula ? leaning : std::span<const std::string_view>{};
}

}  // namespace tiretherm::solver
