// SPDX-License-Identifier: BSD-3-Clause
// Parses and evaluates formulas with muParser and locates errors in the text. The only file that includes muParser.

#include "input/effects/user_formula.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include <fmt/format.h>
#include <muParser.h>

#include "input/text/characters.hpp"

namespace tiretherm::input {

struct Formula::Parser {
    mu::Parser parser;           ///< of the text as written, for errors with their places
    mu::Parser recording;        ///< evaluates the same formula; its comparisons and kinks write to `record`
    std::vector<double> values;  ///< where the variables of both stand
};

namespace {

constexpr std::string_view example = "write a formula of signals, such as \"speed * abs(lateral_force)\"";

/// Where a single = stands, which would assign instead of compare.
std::size_t find_assignment(const std::string& text) {
    for (std::size_t i = text.find('='); i != std::string::npos; i = text.find('=', i + 1)) {
        if (i + 1 < text.size() && text[i + 1] == '=') {
            ++i;
        } else if (i == 0 || std::string_view("<>!").find(text[i - 1]) == std::string_view::npos) {
            return i;
        }
    }
    return std::string::npos;
}

/// Where the recording functions write. The library hands them no argument of their own.
thread_local FormulaDecisions* record = nullptr;

double decided(double result, double margin) {
    if (record != nullptr) {
        record->taken.push_back(result);
        record->margins.push_back(margin);
    }
    return result;
}

template <typename Compare>
double compared(double a, double b) {
    return decided(Compare()(a, b) ? 1.0 : 0.0, a - b);
}
double both(double a, double b) { return decided(a != 0.0 && b != 0.0 ? 1.0 : 0.0, 0.0); }
double either(double a, double b) { return decided(a != 0.0 || b != 0.0 ? 1.0 : 0.0, 0.0); }

double sign_of(double a) {
    const double positive = a > 0.0 ? 1.0 : 0.0;
    return decided(a < 0.0 ? -1.0 : positive, a);
}
double magnitude(double a) {
    sign_of(a);
    return std::abs(a);
}
/// Upwards from the half, as the library does it; std::rint goes to the even number.
double nearest_integer(double a) { return decided(std::floor(a + 0.5), a - std::floor(a) - 0.5); }

/// The smallest of several with std::less, the largest with std::greater.
template <typename Compare>
double first_by(const double* a, int count) {
    const double* found = std::min_element(a, a + count, Compare());
    decided(static_cast<double>(found - a), count == 2 ? a[0] - a[1] : 0.0);
    return *found;
}

struct RecordedOperator {
    std::string_view written;
    const char* name;  ///< in the recording parser, which keeps the library's own operators for arithmetic
    double (*function)(double, double);
    int precedence;
};

// The longer ones first, as they are looked for.
constexpr std::array<RecordedOperator, 8> recorded_operators{{
    {"<=", "$le$", compared<std::less_equal<>>, mu::prCMP},
    {">=", "$ge$", compared<std::greater_equal<>>, mu::prCMP},
    {"==", "$eq$", compared<std::equal_to<>>, mu::prCMP},
    {"!=", "$ne$", compared<std::not_equal_to<>>, mu::prCMP},
    {"&&", "$and$", both, mu::prLAND},
    {"||", "$or$", either, mu::prLOR},
    {"<", "$lt$", compared<std::less<>>, mu::prCMP},
    {">", "$gt$", compared<std::greater<>>, mu::prCMP},
}};

std::string with_recorded_operators(std::string_view text) {
    std::string written;
    while (!text.empty()) {
        const auto* const found = std::ranges::find_if(
            recorded_operators, [&](const RecordedOperator& entry) { return text.starts_with(entry.written); });
        if (found == recorded_operators.end()) {
            written += text.front();
            text.remove_prefix(1);
        } else {
            written += fmt::format(" {} ", found->name);
            text.remove_prefix(found->written.size());
        }
    }
    return written;
}

void prepare_recording(mu::Parser& parser, const std::string& text) {
    parser.DefineOprtChars("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ+-*^/?<>=#!$%&|~'_");
    for (const RecordedOperator& entry : recorded_operators) {
        parser.DefineOprt(entry.name, entry.function, static_cast<unsigned>(entry.precedence));
    }
    parser.DefineFun("abs", magnitude);
    parser.DefineFun("sign", sign_of);
    parser.DefineFun("rint", nearest_integer);
    parser.DefineFun("min", first_by<std::less<>>);
    parser.DefineFun("max", first_by<std::greater<>>);
    parser.EnableOptimizer(false);  // which would evaluate what is constant once, and record it then
    // Where an operator may stand, the library compares as many characters as its longest name has, also beyond the end of
    // the text: blanks stand there.
    parser.SetExpr(with_recorded_operators(text) + "        ");
}

/// The library's sentence without its place, which is shown.
std::string sentence(std::string message) {
    for (const std::string_view place : {" found at position", " at position"}) {
        if (const std::size_t end = message.find(place); end != std::string::npos) {
            message.erase(end);
        }
    }
    while (!message.empty() && (message.back() == '.' || message.back() == ' ')) {
        message.pop_back();
    }
    if (!message.empty() && message.front() >= 'A' && message.front() <= 'Z') {
        message.front() = static_cast<char>(message.front() - 'A' + 'a');
    }
    return message;
}

}  // namespace

std::optional<Formula> Formula::read(const std::string& text, std::string_view name, Wrong& wrong) {
    if (trim(text).empty()) {
        wrong = {.error = {fmt::format("{} is empty", name), std::string(example)}};
        return std::nullopt;
    }
    if (const std::size_t assignment = find_assignment(text); assignment != std::string::npos) {
        wrong = {
            .error = {fmt::format("{} assigns a value", name), "compare with =="}, .from = assignment, .length = 1};
        return std::nullopt;
    }
    Formula formula;
    formula.parser_ = std::make_shared<Parser>();
    mu::Parser& parser = formula.parser_->parser;
    try {
        parser.SetExpr(text);
        for (const auto& [signal, unbound] : parser.GetUsedVar()) {
            formula.signals_.push_back(signal);
        }
        formula.parser_->values.assign(formula.signals_.size(), 1.0);
        for (std::size_t i = 0; i < formula.signals_.size(); ++i) {
            parser.DefineVar(formula.signals_[i], &formula.parser_->values[i]);
            formula.parser_->recording.DefineVar(formula.signals_[i], &formula.parser_->values[i]);
        }
        int results = 0;
        parser.Eval(results);
        if (results != 1) {
            wrong = {.error = {fmt::format("{} has {} values, separated by commas", name, results),
                               "write one formula; a decimal point is a point"}};
            return std::nullopt;
        }
        prepare_recording(formula.parser_->recording, text);
        formula.parser_->recording.Eval();
    } catch (const mu::ParserError& error) {
        wrong = {.error = {fmt::format("{} is no formula: {}", name, sentence(error.GetMsg())), std::string(example)},
                 .from = std::min(static_cast<std::size_t>(std::max(error.GetPos(), 0)), text.size()),
                 .length = error.GetToken().size()};
        return std::nullopt;
    }
    return formula;
}

Formula Formula::of_signal(const std::string& name) {
    Formula formula;
    formula.parser_ = std::make_shared<Parser>();
    formula.signals_ = {name};
    formula.parser_->values = {1.0};
    formula.parser_->parser.DefineVar("signal", formula.parser_->values.data());
    formula.parser_->parser.SetExpr("signal");
    formula.parser_->recording = formula.parser_->parser;
    return formula;
}

double Formula::evaluate(std::span<const double> values, FormulaDecisions& decisions) const {
    decisions.taken.clear();
    decisions.margins.clear();
    std::ranges::copy(values, parser_->values.begin());
    record = &decisions;
    const double value = parser_->recording.Eval();
    record = nullptr;
    decisions.taken.push_back(std::isfinite(value) ? 1.0 : 0.0);
    decisions.margins.push_back(0.0);
    return value;
}

}  // namespace tiretherm::input
