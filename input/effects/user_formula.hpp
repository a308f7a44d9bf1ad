// SPDX-License-Identifier: BSD-3-Clause
// Formula of named signals for user effects, such as "speed * abs(lateral_force)".
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "input/text/input_error.hpp"

namespace tiretherm::input {

/// A formula of named signals: "speed * abs(lateral_force)", "max(0, brake - 0.1)". Its words are those of the library
/// muParser: + - * / ^, comparisons, && ||, a > b ? c : d; abs, min, max, sqrt, exp, ln, log10, sin, cos, tan and more;
/// the constants _pi and _e.
class Formula {
public:
    /// What is wrong with a formula, and where in its text.
    struct Wrong {
        ErrorText error;
        std::size_t from = 0;    ///< characters from its beginning
        std::size_t length = 0;  ///< 0: the text as a whole
    };
    /// @param name what messages call the text: "follows"  @returns nothing, and what is wrong, for no formula
    [[nodiscard]] static std::optional<Formula> read(const std::string& text, std::string_view name, Wrong& wrong);

    /// A signal itself, whatever its name looks like: "T brake".
    [[nodiscard]] static Formula of_signal(const std::string& name);

    /// The signals it needs, in the order in which values are given.
    [[nodiscard]] const std::vector<std::string>& signals() const { return signals_; }
    /// @param values [signals]
    [[nodiscard]] double operator()(std::span<const double> values) const;

private:
    struct Parser;
    std::shared_ptr<Parser> parser_;
    std::vector<std::string> signals_;
};

}  // namespace tiretherm::input
