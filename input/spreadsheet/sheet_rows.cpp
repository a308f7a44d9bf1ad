// SPDX-License-Identifier: BSD-3-Clause
// Finds parameters in the rows of a sheet as name, value, unit and note, and reports unknown names and wrong units.

#include "input/spreadsheet/sheet_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "input/text/quantity.hpp"
#include "input/text/suggestions.hpp"

namespace tiretherm::input {

namespace {

constexpr std::array<std::string_view, 11> heading_words{
    "Value", "Values", "Unit", "Units", "Parameter", "Parameters", "Note", "Notes", "Remark", "Remarks", "Comment"};

bool is_heading_word(std::string_view text) {
    return std::ranges::any_of(heading_words, [&](std::string_view word) { return is_called(text, word, ""); });
}

/// Reads the rows of one sheet.
class Scan {
public:
    Scan(const SheetBook& book, const Sheet& sheet, std::string_view name, SheetContent& content, InputErrors& errors)
        : book_(book), sheet_(sheet), name_(name), content_(content), errors_(errors) {}

    void rows() {
        for (std::size_t r = 0; r < sheet_.rows.size(); ++r) {
            if (is_remark(r)) {
                continue;
            }
            if (const std::size_t taken = scan_tables(sheet_, name_, r, content_, errors_); taken > 0) {
                r += taken - 1;
            } else {
                row(r);
            }
        }
    }

private:
    /// A blank row, one that begins with #, or one of headings alone.
    [[nodiscard]] bool is_remark(std::size_t r) const {
        const std::vector<SheetCell>& cells = sheet_.rows[r];
        const auto first =
            std::find_if(cells.begin(), cells.end(), [](const SheetCell& cell) { return !cell.text.empty(); });
        return first == cells.end() || first->text.starts_with('#') ||
               std::all_of(first, cells.end(), [](const SheetCell& cell) {
                   return cell.text.empty() || is_heading_word(cell.text) || is_called(cell.text, "[-]", "");
               });
    }

    /// The parameter that a cell names, by itself or with the label to its left.
    [[nodiscard]] const SheetParameter* named(std::size_t r, std::size_t c) const {
        const std::string& text = sheet_.at(r, c).text;
        const auto label = c > 0 ? labels_.find(c - 1) : labels_.end();
        if (!text.empty() && label != labels_.end()) {
            if (const SheetParameter* found = find_sheet_parameter(name_, label->second + " " + text)) {
                return found;
            }
        }
        return text.empty() ? nullptr : find_sheet_parameter(name_, text);
    }

    void row(std::size_t r) {
        const std::size_t width = sheet_.rows[r].size();
        bool first = true;
        for (std::size_t c = 0; c < width;) {
            const SheetCell& cell = sheet_.at(r, c);
            if (is_sheet_label(name_, cell.text)) {
                labels_[c] = cell.text;
                ++c;
            } else if (const SheetParameter* parameter = named(r, c)) {
                take(*parameter, r, c);
                first = false;
                c += 3;
            } else {
                // After a parameter there may stand a note; another group begins with a name or a label.
                if (first && !cell.text.empty()) {
                    unknown(r, c);
                    return;
                }
                ++c;
            }
        }
    }

    /// A name that the sheet does not know, or a title when it stands alone.
    void unknown(std::size_t r, std::size_t c) {
        const SheetCell& cell = sheet_.at(r, c);
        const std::vector<SheetCell>& cells = sheet_.rows[r];
        const bool alone =
            std::all_of(cells.begin() + static_cast<std::ptrdiff_t>(c) + 1, cells.end(),
                        [](const SheetCell& other) { return other.text.empty() || is_heading_word(other.text); });
        if (const std::optional<Number> number = leading_number(cell.text); number && number->rest.empty()) {
            errors_.add(cell.place, fmt::format("{} stands in the place of a parameter's name", cell.text),
                        "begin a remark with #");
            return;
        }
        if (alone) {
            return;
        }
        for (const SheetParameter& other : sheet_parameters()) {
            if (other.sheet != name_ && is_called(cell.text, other.name, other.aliases)) {
                errors_.add(cell.place, fmt::format("{} has no parameter \"{}\"", name_, cell.text),
                            fmt::format("it belongs into the sheet {}", other.sheet));
                return;
            }
        }
        std::vector<std::string> known;
        for (const SheetParameter& parameter : sheet_parameters()) {
            if (parameter.sheet == name_) {
                known.emplace_back(parameter.name);
            }
        }
        const std::string label = c > 0 && labels_.contains(c - 1) ? labels_.at(c - 1) + " " : "";
        errors_.add(cell.place, fmt::format("{} has no parameter \"{}{}\"", name_, label, cell.text),
                    suggest(label + cell.text, known, "parameters") +
                        (nearest(label + cell.text, known).empty() ? "; begin a remark with #" : ""));
    }

    /// The parameter whose name stands at r, c with its value and its unit to the right.
    void take(const SheetParameter& parameter, std::size_t r, std::size_t c) {
        const SheetCell& name = sheet_.at(r, c);
        const SheetCell& value = sheet_.at(r, c + 1);
        if (value.text.empty()) {
            // As good as not there, unless there may be a formula.
            if (sheet_.hides_formulas) {
                errors_.add(name.place,
                            fmt::format("the value of {} is empty or a formula, which an .xls does not give away",
                                        parameter.name),
                            formula_remedy);
            }
            return;
        }
        if (const SheetValue* same = content_.find(parameter)) {
            const bool alias = !is_called(name.text, parameter.name, "");
            errors_.add(name.place,
                        fmt::format("{} stands twice{}, first at {}", parameter.name,
                                    alias ? fmt::format(", here as \"{}\"", name.text) : "",
                                    spell(book_, sheet_, same->name_place, errors_)),
                        "remove one of them");
            return;
        }
        SheetValue found{.parameter = &parameter,
                         .text = value.text,
                         .number = 0.0,
                         .unit = plain_unit(sheet_.at(r, c + 2).text),
                         .name_place = name.place,
                         .place = value.place};
        read(found, value, sheet_.at(r, c + 2));
        content_.values.push_back(std::move(found));
    }

    void read(SheetValue& found, const SheetCell& value, const SheetCell& unit) {
        const SheetParameter& parameter = *found.parameter;
        const auto refuse = [&](const SheetCell& cell, ErrorText error) {
            errors_.add(cell.place, std::move(error));
            found.sound = false;
        };
        switch (parameter.use) {
            case SheetUse::text:
                return;
            case SheetUse::on:
            case SheetUse::word:
            case SheetUse::sensor:
                if (is_called(value.text, "on", "1|true|yes")) {
                    found.number = 1.0;
                } else if (!is_called(value.text, "off", "0|false|no")) {
                    refuse(value, {fmt::format("{} is \"{}\"", parameter.name, value.text), "write ON or OFF"});
                }
                return;
            case SheetUse::scale:
                found.text = plain_unit(value.text);
                if (is_called(found.text, "degC", "C|Celsius")) {
                    found.text = "degC";
                } else if (is_called(found.text, "K", "kelvin")) {
                    found.text = "K";
                } else {
                    refuse(value, {fmt::format("{} is \"{}\"", parameter.name, value.text), "write degC or K"});
                }
                return;
            default:
                break;
        }
        const std::optional<Number> number = leading_number(value.text);
        const bool own_unit = number && unit.text.empty() && !number->rest.empty() && number->rest[0] != ',';
        if (!number || !std::isfinite(number->value) || (!number->rest.empty() && !own_unit)) {
            refuse(value, not_a_number(parameter.name, value.text));
            return;
        }
        found.number = number->value;
        if (own_unit) {
            found.unit = plain_unit(number->rest);
        }
        if (is_called_unit(found.unit, parameter)) {
            found.unit = parameter.unit;
        }
        if (parameter.unit == "1" && found.unit.empty()) {
            found.unit = "1";
        }
        if (std::optional<ErrorText> error = unit_error(found.unit, parameter.unit, parameter.name)) {
            refuse(unit.text.empty() ? value : unit, std::move(*error));
        } else if (found.unit == "-") {
            found.unit = "1";
        } else if (parameter.use == SheetUse::computed && found.number <= 0.0) {
            refuse(value, {fmt::format("{} is {}; it must be above 0", parameter.name, value.text), ""});
        }
    }

    /// Whether the thesis prints this unit for the parameter.
    [[nodiscard]] static bool is_called_unit(std::string_view unit, const SheetParameter& parameter) {
        std::string_view printed = parameter.printed;
        while (!printed.empty()) {
            const std::size_t end = std::min(printed.find('|'), printed.size());
            if (unit == printed.substr(0, end)) {
                return true;
            }
            printed.remove_prefix(std::min(end + 1, printed.size()));
        }
        return false;
    }

    const SheetBook& book_;
    const Sheet& sheet_;
    std::string_view name_;
    SheetContent& content_;
    InputErrors& errors_;
    std::map<std::size_t, std::string> labels_;  ///< by column; a label holds for the rows below it
};

}  // namespace

const SheetValue* SheetContent::find(const SheetParameter& parameter) const {
    const auto found =
        std::ranges::find_if(values, [&](const SheetValue& value) { return value.parameter == &parameter; });
    return found == values.end() ? nullptr : &*found;
}

void scan_sheet(const SheetBook& book, const Sheet& sheet, SheetContent& content, InputErrors& errors) {
    const auto name =
        std::ranges::find_if(sheet_names(), [&](std::string_view known) { return is_called(sheet.name, known, ""); });
    Scan(book, sheet, *name, content, errors).rows();
}

}  // namespace tiretherm::input
