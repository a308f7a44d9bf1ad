// SPDX-License-Identifier: BSD-3-Clause
// Turns units as spreadsheets write them ("W/m 2 K", raised digits) into units of a case and checks their dimension.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "input/spreadsheet/sheet_rows.hpp"
#include "input/text/quantity.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/unit_text.hpp"

namespace tiretherm::input {

namespace {

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
        text.replace(at, from.size(), to);
    }
}

}  // namespace

std::string plain_unit(std::string_view written) {
    written = trim(written);
    if (written.size() > 1 && written.front() == '[' && written.back() == ']') {
        written = trim(written.substr(1, written.size() - 2));
    }
    std::string unit(written);
    constexpr std::array<std::array<std::string_view, 2>, 7> spellings{{{"\u00B2", "2"},
                                                                        {"\u00B3", "3"},
                                                                        {"\u00B0C", "degC"},
                                                                        {"\u00BAC", "degC"},
                                                                        {"\u2103", "degC"},
                                                                        {"Kg", "kg"},
                                                                        {"\u00A0", " "}}};
    for (const auto& [from, to] : spellings) {
        replace_all(unit, from, to);
    }
    // "W/m 2 K" as spreadsheets set raised digits; without a slash a blank is a product.
    if (const std::size_t slash = unit.find('/'); slash != std::string::npos) {
        unit.erase(std::remove(unit.begin() + static_cast<std::ptrdiff_t>(slash), unit.end(), ' '), unit.end());
    }
    return unit;
}

std::optional<ErrorText> unit_error(std::string_view unit, std::string_view wanted, std::string_view name) {
    const std::string remedy = fmt::format("write {}", wanted == "1" ? "-" : wanted);
    if (unit.empty()) {
        return ErrorText{fmt::format("{} has no unit", name), remedy};
    }
    const std::string si = spelt_out(wanted);
    // The scale on which a unit counts does not matter for its dimension.
    UnitRead read = read_unit(unit, QuantitySpec{.unit = si}, fmt::format("{} is in \"{}\"", name, unit));
    if (read.error) {
        read.error->remedy = remedy;
    }
    return read.error;
}

ErrorText not_a_number(std::string_view name, std::string_view text) {
    const std::optional<Number> number = leading_number(text);
    if (number && number->rest.starts_with(',')) {
        return {fmt::format("{} is \"{}\", with a comma in the number", name, text), "write a decimal point"};
    }
    return {fmt::format("{} is \"{}\"; a number is wanted", name, text), ""};
}

}  // namespace tiretherm::input
