// SPDX-License-Identifier: BSD-3-Clause
// Parses and evaluates formulas with muParser and locates errors in the text. The only file that includes muParser.

#include "input/effects/user_formula.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <muParser.h>

#include "input/text/suggestions.hpp"

namespace tiretherm::input {

struct Formula::Parser {
    mu::Parser parser;
    std::vector<double> values;  ///< where its variables stand
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
        }
        int results = 0;
        parser.Eval(results);
        if (results != 1) {
            wrong = {.error = {fmt::format("{} has {} values, separated by commas", name, results),
                               "write one formula; a decimal point is a point"}};
            return std::nullopt;
        }
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
    return formula;
}

double Formula::operator()(std::span<const double> values) const {
    std::ranges::copy(values, parser_->values.begin());
    return parser_->parser.Eval();
}

}  // namespace tiretherm::input
