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

/// What an evaluation of a formula decided, in the order of its terms: the results of comparisons, && and ||, the
/// signs in abs and sign, the index of the smallest in min and of the largest in max, what rint made. Between two
/// evaluations that decided the same, the formula is smooth unless a term went there and back.
struct FormulaDecisions {
    std::vector<double> taken;
    /// How far each was from another result: a - b of a comparison, the argument of abs and sign. 0 for && and ||.
    std::vector<double> margins;
};

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
    /// Its value, and what was decided on the way. @param values [signals]  @param decisions out
    double evaluate(std::span<const double> values, FormulaDecisions& decisions) const;

private:
    struct Parser;
    std::shared_ptr<Parser> parser_;
    std::vector<std::string> signals_;
};

}  // namespace tiretherm::input
