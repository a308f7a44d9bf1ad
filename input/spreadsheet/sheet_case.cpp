// SPDX-License-Identifier: BSD-3-Clause
// Converts in three steps: scan the sheets, write the case, read the case to check it; errors are reported at the
// cells.

#include "input/spreadsheet/sheet_case.hpp"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

#include "input/measurements/runs.hpp"
#include "input/spreadsheet/sheet_body.hpp"
#include "input/spreadsheet/sheet_remarks.hpp"
#include "input/text/suggestions.hpp"
#include "input/toml/document.hpp"

namespace tiretherm::input {

namespace {

constexpr std::string_view whole_case = "the case";

/// Reads all sheets; those that are missing or that nobody knows are errors.
SheetContent read_content(const SheetBook& book, SheetCase& result, InputErrors& errors) {
    SheetContent content;
    std::vector<std::string> strange;
    for (const Sheet& sheet : book.sheets) {
        const bool known =
            std::ranges::any_of(sheet_names(), [&](std::string_view name) { return is_called(sheet.name, name, ""); });
        if (known) {
            result.sheets.push_back(sheet.name);
            scan_sheet(book, sheet, content, errors);
        } else {
            strange.push_back(sheet.name);
        }
    }
    const std::string ending = book.is_folder ? ".csv" : "";
    const int whole = errors.add_file(book.shown, "");
    if (result.sheets.empty()) {
        const std::vector<std::string> wanted(sheet_names().begin(), sheet_names().end());
        errors.add({.file = whole}, fmt::format("none of the ten sheets is there; there is {}", listed(strange)),
                   fmt::format("the sheets are {}: cases/convert/README.md describes them", listed(wanted)));
        return content;
    }
    for (const std::string_view name : sheet_names()) {
        const auto is = [&](const Sheet& sheet) { return is_called(sheet.name, name, ""); };
        const auto count = std::ranges::count_if(book.sheets, is);
        if (count > 1) {
            errors.add({.file = whole}, fmt::format("there are {} sheets {}", count, name), "keep one of them");
        }
        if (count == 0) {
            const std::string near = nearest(name, strange);
            errors.add({.file = whole}, fmt::format("there is no sheet {}{}", name, ending),
                       near.empty() ? fmt::format("add it; one with a title alone takes all defaults of {}", name)
                                    : fmt::format("rename {}{}?", near, ending));
            std::erase(strange, near);
        }
    }
    for (const std::string& name : strange) {
        errors.warn({.file = whole}, fmt::format("the sheet {} is none of the ten and is not read", name));
    }
    return content;
}

/// The sheets must name the tire: nothing else can be assumed.
bool check_size(const SheetBook& book, const SheetContent& content, InputErrors& errors) {
    const SheetParameter& size = *find_sheet_parameter("INFO", "Size");
    const Sheet* info = book.find("INFO");
    const bool given = content.find(size) != nullptr;
    if (!given && info != nullptr && info->place.file >= 0) {
        errors.add(info->place, "the sheet has no Size", "add a row: Size, 225/50 R17");
    }
    return given;
}

/// A sentence about a key of the case as one about the parameter that it came from.
std::string called(const SheetBody::Entry& entry, const std::string& sentence) {
    return sentence.starts_with(entry.key) ? entry.called + sentence.substr(entry.key.size())
                                           : fmt::format("{}: {}", entry.called, sentence);
}

/// Reports the errors that the reader of cases finds in the body at their places in the sheets.
void report_in_sheets(const SheetBody& body, const SheetBook& book, const InputErrors& case_errors,
                      InputErrors& errors) {
    const std::vector<InputError> found = case_errors.in_order();
    const int whole = found.empty() ? -1 : errors.add_file(book.shown, "");
    for (const InputError& error : found) {
        const SheetBody::Entry* entry = body.entry_at(error.line);
        std::string what = entry != nullptr ? called(*entry, error.what) : error.what;
        SourceLocation place = body.place_at(error.line);
        if (place.file < 0) {
            place = {.file = whole};
            what += entry != nullptr ? fmt::format(" ({} is assumed, the sheets do not say it)", entry->key) : "";
        }
        errors.add(place, what, error.remedy);
    }
}

/// "the case:12: ..." as a sentence about the sheet that line 12 came from.
std::string moved(const std::string& warning, const SheetBody& body, const SheetBook& book) {
    const std::string prefix = std::string(whole_case) + ":";
    const std::size_t end = warning.find(": ");
    if (!warning.starts_with(prefix) || end == std::string::npos || end <= prefix.size()) {
        return fmt::format("{}: {}", book.shown, warning);
    }
    const SheetBody::Entry* entry = body.entry_at(std::atoi(warning.c_str() + prefix.size()));
    const std::string what = warning.substr(end + 2);
    return fmt::format("{}: {}", book.shown, entry != nullptr ? called(*entry, what) : what);
}

/// A tire of another size that borrows laws of the load.
void warn_of_borrowed_laws(const SheetContent& content, const SheetBook& book, SheetCase& result) {
    const SheetValue* size = content.find(*find_sheet_parameter("INFO", "Size"));
    if (size == nullptr || is_called(size->text, "225/50 R17", "225/50R17")) {
        return;
    }
    std::vector<std::string> borrowed;
    for (const SheetMissing& missing : result.missing) {
        if ((missing.sheet == "ContactPatch" || missing.sheet == "Radius") && !missing.value.empty()) {
            borrowed.push_back(missing.parameter);
        }
    }
    if (!borrowed.empty()) {
        result.warnings.push_back(fmt::format("{}: {} of the {} {} taken from the thesis's 225/50 R17: give its own",
                                              book.shown, listed(borrowed), size->text,
                                              borrowed.size() > 1 ? "are" : "is"));
    }
}

std::string comment(const std::string& text) { return fmt::format("# {}\n", printable(text)); }

/// What a reader of the case must know: what was assumed and what was left out.
std::string preamble(const SheetCase& result) {
    std::string text =
        comment("Made by tiretherm convert of the ten sheets of a thesis's spreadsheet: the two-node model.");
    text += comment("To run it otherwise, write a case that includes this one and says what differs.");
    text += comment("Not in the sheets and assumed:");
    for (const SheetMissing& missing : result.missing) {
        const std::string where =
            missing.sheet.empty() ? "" : fmt::format(" ({}: {})", missing.sheet, missing.parameter);
        const std::string value = missing.value.empty() ? "" : " = " + missing.value;
        text += comment(fmt::format("    {}{}{}: {}", missing.key, value, where, missing.reason));
    }
    if (!result.unmapped.empty()) {
        text += comment("In the sheets, but without a place in a case:");
    }
    for (const SheetUnmapped& unmapped : result.unmapped) {
        text += comment(
            fmt::format("    {}: {} = {}: {}", unmapped.sheet, unmapped.parameter, unmapped.value, unmapped.reason));
    }
    return text + "\n";
}

}  // namespace

SheetCase convert_sheet(const std::filesystem::path& path) {
    SheetCase result;
    InputErrors errors;
    const std::optional<SheetBook> book = read_sheet_book(path, errors);
    if (!book) {
        result.errors = errors.in_order();
        return result;
    }
    const SheetContent content = read_content(*book, result, errors);
    const bool has_size = check_size(*book, content, errors);
    SheetBody body = make_sheet_body(content, result, errors);
    if (!has_size) {  // so that the rest is checked all the same
        body.add(
            {.table = "tire", .key = "size", .lines = {"\"225/50 R17\""}, .places = {{}}, .remark = "", .called = ""});
    }
    InputErrors case_errors;
    const std::string text = body.text();
    const TextFile file{.number = case_errors.add_file(std::string(whole_case), text), .text = text};
    std::optional<solver::Problem> problem;
    if (const std::optional<TomlValue> document = parse_toml(file, case_errors)) {
        Runs runs = read_runs(*document, path.stem().string(), {}, ReadMode::measured, case_errors);
        if (case_errors.count() == 0) {
            problem = std::move(runs.problem);
        }
    }
    report_in_sheets(body, *book, case_errors, errors);
    result.warnings = errors.warnings();
    warn_of_borrowed_laws(content, *book, result);
    for (const std::string& warning : case_errors.warnings()) {
        result.warnings.push_back(moved(warning, body, *book));
    }
    if (errors.count() > 0) {
        result.errors = with_cells(errors.in_order(), *book);
        return result;
    }
    compare_with_sheet(content, *problem, result);
    result.text = preamble(result) + body.text();
    return result;
}

}  // namespace tiretherm::input
