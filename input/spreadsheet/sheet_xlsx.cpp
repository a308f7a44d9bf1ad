// SPDX-License-Identifier: BSD-3-Clause
// Reads Office Open XML workbooks (.xlsx) with pugixml: sheets, shared strings and stored cell values.

#include <cctype>
#include <charconv>
#include <map>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "input/spreadsheet/sheet_formats.hpp"
#include "input/text/quantity.hpp"

namespace tiretherm::input {

namespace {

constexpr std::size_t most_rows = 10'000;
constexpr std::size_t most_columns = 256;

/// The name without its prefix: writers put the elements into a namespace or not.
std::string_view local(const pugi::xml_node& node) {
    const std::string_view name = node.name();
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

pugi::xml_node child(const pugi::xml_node& of, std::string_view name) {
    return of.find_child([&](const pugi::xml_node& node) { return local(node) == name; });
}

/// All text of a string item: it may be cut into runs of different fonts. Readings in another script are left out.
std::string text_in(const pugi::xml_node& item) {
    std::string text;
    for (const pugi::xml_node& node : item.children()) {
        if (local(node) == "t") {
            text += node.text().get();
        } else if (local(node) == "r") {
            text += text_in(node);
        }
    }
    return text;
}

std::vector<std::string> shared_strings(const ZipParts& parts) {
    std::vector<std::string> strings;
    pugi::xml_document document;
    const std::optional<std::string> xml = parts("xl/sharedStrings.xml");
    if (xml && document.load_buffer(xml->data(), xml->size(), pugi::parse_default | pugi::parse_ws_pcdata)) {
        for (const pugi::xml_node& item : document.document_element().children()) {
            if (local(item) == "si") {
                strings.push_back(text_in(item));
            }
        }
    }
    return strings;
}

/// Row and column of "B4", from 0; nothing for what is none.
struct Spot {
    std::size_t row;
    std::size_t column;
};
std::optional<Spot> spot_of(std::string_view reference) {
    std::size_t column = 0;
    while (!reference.empty() && reference.front() >= 'A' && reference.front() <= 'Z' && column < most_columns) {
        column = 26 * column + static_cast<std::size_t>(reference.front() - 'A') + 1;
        reference.remove_prefix(1);
    }
    std::size_t row = 0;
    const auto [end, error] = std::from_chars(reference.data(), reference.data() + reference.size(), row);
    const bool whole = error == std::errc() && end == reference.data() + reference.size();
    return whole && column > 0 && row > 0 ? std::optional(Spot{row - 1, column - 1}) : std::nullopt;
}

std::string value_of(const pugi::xml_node& cell, const std::vector<std::string>& strings) {
    const std::string_view type = cell.attribute("t").value();
    const std::string value = child(cell, "v").text().get();
    if (const pugi::xml_node formula = child(cell, "f"); formula && value.empty()) {
        return fmt::format("={}", formula.text().get());  // never computed, by a program that only writes workbooks
    }
    if (type == "s") {
        std::size_t i = 0;
        const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), i);
        return error == std::errc() && i < strings.size() ? strings[i] : std::string();
    }
    if (type == "inlineStr") {
        return text_in(child(cell, "is"));
    }
    if (type == "b") {
        return value == "1" ? "TRUE" : "FALSE";
    }
    const std::optional<Number> number = leading_number(value);
    const bool numeric = type.empty() || type == "n";
    return numeric && number && number->rest.empty() ? cell_text(number->value) : value;
}

RawSheet read_worksheet(const pugi::xml_node& worksheet, std::string name, const std::vector<std::string>& strings) {
    RawSheet sheet{.name = std::move(name), .rows = {}};
    Spot next{0, 0};  // cells without a reference follow each other
    for (const pugi::xml_node& row : child(worksheet, "sheetData").children()) {
        next = {row.attribute("r") ? row.attribute("r").as_uint(1) - 1 : next.row, 0};
        for (const pugi::xml_node& cell : row.children()) {
            const Spot spot = spot_of(cell.attribute("r").value()).value_or(next);
            next = {spot.row, spot.column + 1};
            if (spot.row >= most_rows || spot.column >= most_columns) {
                continue;
            }
            sheet.rows.resize(std::max(sheet.rows.size(), spot.row + 1));
            std::vector<std::string>& cells = sheet.rows[spot.row];
            cells.resize(std::max(cells.size(), spot.column + 1));
            cells[spot.column] = value_of(cell, strings);
        }
        ++next.row;
    }
    return sheet;
}

/// Parts of the archive by the ids under which the workbook knows them.
std::map<std::string, std::string, std::less<>> targets(const ZipParts& parts) {
    std::map<std::string, std::string, std::less<>> found;
    pugi::xml_document document;
    const std::optional<std::string> xml = parts("xl/_rels/workbook.xml.rels");
    if (xml && document.load_buffer(xml->data(), xml->size())) {
        for (const pugi::xml_node& relation : document.document_element().children()) {
            const std::string target = relation.attribute("Target").value();
            found[relation.attribute("Id").value()] = target.starts_with('/') ? target.substr(1) : "xl/" + target;
        }
    }
    return found;
}

std::optional<ErrorText> read_parts(const ZipParts& parts, std::vector<RawSheet>& sheets) {
    pugi::xml_document workbook;
    const std::optional<std::string> xml = parts("xl/workbook.xml");
    if (!xml || !workbook.load_buffer(xml->data(), xml->size())) {
        return ErrorText{"the file is a ZIP archive, but not an .xlsx workbook",
                         "save the spreadsheet as .xlsx or .xls"};
    }
    const std::vector<std::string> strings = shared_strings(parts);
    const auto files = targets(parts);
    for (const pugi::xml_node& entry : child(workbook.document_element(), "sheets").children()) {
        std::string id;
        for (const pugi::xml_attribute& attribute : entry.attributes()) {
            const std::string_view name = attribute.name();
            if (name == "id" || name.ends_with(":id")) {
                id = attribute.value();
            }
        }
        const auto file = files.find(id);
        const std::optional<std::string> part = file != files.end() ? parts(file->second) : std::nullopt;
        pugi::xml_document document;
        if (!part || !document.load_buffer(part->data(), part->size(), pugi::parse_default | pugi::parse_ws_pcdata)) {
            return ErrorText{fmt::format("the .xlsx workbook is damaged: its sheet {} cannot be read",
                                         entry.attribute("name").value()),
                             "save it anew"};
        }
        sheets.push_back(read_worksheet(document.document_element(), entry.attribute("name").value(), strings));
    }
    return std::nullopt;
}

}  // namespace

RawBook read_xlsx(const std::filesystem::path& path) {
    RawBook book;
    book.error = with_zip(path, [&](const ZipParts& parts) { return read_parts(parts, book.sheets); });
    return book;
}

}  // namespace tiretherm::input
