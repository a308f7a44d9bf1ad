// SPDX-License-Identifier: BSD-3-Clause
// A result as a value, and the text of its page.
#include "post/report/report.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <fmt/format.h>

#include "post/report/number_text.hpp"
#include "post/report/table.hpp"

namespace tiretherm::post {

namespace {

std::vector<std::string> cells_of(const DataTable::Row& row) {
    std::vector<std::string> cells;
    for (const Field& field : row) {
        if (field.on_page) {
            cells.push_back(field.cell.text);
        }
    }
    return cells;
}

std::string table_text(const DataTable& table, std::size_t indent, std::size_t width) {
    PageColumns columns = page_columns(table);
    std::vector<bool> left = columns.to_right;
    left.flip();
    TextTable lines(std::move(left));
    if (std::ranges::any_of(columns.headings, [](const std::string& heading) { return !heading.empty(); })) {
        lines.add(std::move(columns.headings));
    }
    for (const DataTable::Row& row : table.rows()) {
        lines.add(cells_of(row));
    }
    return lines.text(indent, width);
}

/// The name of a file or a title may have line ends.
std::string one_line(std::string text) {
    std::ranges::replace(text, '\n', ' ');
    return text;
}

/// Further lines begin below the first word.
std::string item_text(const std::string& item, std::size_t indent, std::size_t width) {
    std::string text = wrap(item, indent + 2, width);
    if (!text.empty()) {
        text[indent] = '-';
    }
    return text;
}

std::string blocks_text(const std::vector<PageItem>& blocks, std::size_t indent, const PageWidth& width) {
    std::string text;
    for (const PageItem& block : blocks) {
        switch (block.kind) {
            case PageItem::Kind::paragraph:
                text += wrap(block.text, indent, width.prose);
                break;
            case PageItem::Kind::item:
                text += item_text(block.text, indent, width.prose);
                break;
            case PageItem::Kind::line:
                text += std::string(indent, ' ') + one_line(block.text) + "\n";
                break;
            case PageItem::Kind::gap:
                text += "\n";
                break;
            case PageItem::Kind::table:
                text += table_text(block.table, indent, width.tables);
                break;
            case PageItem::Kind::part:
                text += std::string(indent, ' ') + block.text + "\n" + blocks_text(block.blocks, indent + 2, width);
                break;
            case PageItem::Kind::chart:
                break;
        }
    }
    return text;
}

}  // namespace

PageColumns page_columns(const DataTable& table) {
    PageColumns columns;
    const auto take = [&](const DataTable::Row& row) {
        std::size_t column = 0;
        for (const Field& field : row) {
            if (field.on_page && column++ == columns.headings.size()) {
                columns.headings.push_back(field.heading);
                columns.to_right.push_back(field.cell.to_right);
            }
        }
    };
    take(table.columns());
    std::ranges::for_each(table.rows(), take);
    return columns;
}

Cell shown(std::string_view format, double value) {
    if (!std::isfinite(value)) {
        return {value, "-"};
    }
    const std::string sign = format.find('+') != std::string_view::npos ? "+" : "";
    const std::string text = fmt::format(fmt::runtime(format), value);
    const std::string without = without_sign_of_zero(text);
    return {value, without == text ? text : sign + without};
}

Cell count(std::size_t n) { return {n, grouped(static_cast<double>(n))}; }

Cell right(std::string text) {
    const Value value(text);
    return {value, std::move(text)};
}

Field page_only(std::string heading, Cell cell) { return {std::move(heading), "", std::move(cell)}; }

Field data_only(std::string key, Value value) {
    Field field("", std::move(key), Cell(std::move(value), ""));
    field.on_page = false;
    return field;
}

void DataTable::add_to_page(Row row) {
    for (Field& field : row) {
        field.key.clear();
    }
    rows_.push_back(std::move(row));
}

Value object_of(const std::vector<Field>& row) {
    Value object;
    for (const Field& field : row) {
        if (!field.key.empty()) {
            object.set(field.key, field.cell.value);
        }
    }
    return object;
}

Value DataTable::data() const {
    Value::List list;
    for (const Row& row : rows_) {
        Value object = object_of(row);
        if (!std::holds_alternative<std::monostate>(object.held())) {
            list.push_back(std::move(object));
        }
    }
    return list;
}

ReportSection::ReportSection(std::string heading, const std::vector<std::string>& paragraphs)
    : heading_(std::move(heading)) {
    for (const std::string& paragraph : paragraphs) {
        say(paragraph);
    }
}

void ReportSection::say(std::string paragraph) {
    if (!paragraph.empty()) {
        add(PageItem::Kind::paragraph, std::move(paragraph));
    }
}

void ReportSection::gap() {
    if (!blocks_.empty()) {
        add(PageItem::Kind::gap, "");
    }
}

void ReportSection::add(DataTable table) {
    if (!table.empty()) {
        blocks_.push_back({PageItem::Kind::table, "", std::move(table), {}});
    }
}

void ReportSection::add(ReportSection part) {
    blocks_.push_back({PageItem::Kind::part, std::move(part.heading_), {}, std::move(part.blocks_)});
}

void ReportSection::chart(std::string title, std::string caption, Value data) {
    blocks_.push_back({PageItem::Kind::chart, std::move(title), {}, {}, std::move(caption), std::move(data)});
}

bool ReportSection::has_text() const {
    return std::ranges::any_of(blocks_, [](const PageItem& block) { return block.kind != PageItem::Kind::chart; });
}

void Report::add(std::string heading, std::string key, const std::vector<std::string>& sentences) {
    data.set(std::move(key), sentences);
    add(ReportSection(std::move(heading), sentences));
}

void Report::add_warnings(std::vector<std::string> warnings, const std::vector<std::string>& of_laws) {
    warnings.insert(warnings.end(), of_laws.begin(), of_laws.end());
    add("Warnings", "warnings", warnings);
}

void Report::add_verdict(std::vector<std::string> sentences) {
    add(ReportSection(verdict_heading, sentences));
    verdict = std::move(sentences);
}

void Report::add(const std::vector<std::filesystem::path>& files) {
    ReportSection section("Files");
    Value::List outputs;
    for (const std::filesystem::path& file : files) {
        section.line(file.string());
        outputs.push_back(file.generic_string());
    }
    data.set("outputs", std::move(outputs));
    add(std::move(section));
}

std::string plural(std::size_t n, std::string_view thing) {
    return fmt::format("{} {}{}", n, thing, n == 1 ? "" : "s");
}

const ReportSection& section(const Report& report, std::string_view heading) {
    const auto found = std::ranges::find(report.sections, heading, &ReportSection::heading);
    assert(found != report.sections.end());
    return *found;
}

std::string page_text(const Report& report, bool bold, const PageWidth& width) {
    const auto strong = [&](const std::string& line) {
        return bold ? fmt::format("\033[1m{}\033[0m\n", line) : line + "\n";
    };
    std::string text = strong(one_line(report.title));
    if (std::ranges::find(report.sections, verdict_heading, &ReportSection::heading) == report.sections.end()) {
        for (const std::string& line : report.verdict) {
            text += wrap(one_line(line), 0, width.prose);
        }
    }
    for (const std::string& line : report.lead) {
        text += one_line(line) + "\n";
    }
    for (const ReportSection& section : report.sections) {
        if (!section.has_text()) {
            continue;
        }
        const bool after_title = section.heading().empty() && &section == &report.sections.front();
        text += after_title ? "" : "\n";
        text += section.heading().empty() ? "" : strong(section.heading());
        text += blocks_text(section.blocks(), 2, width);
    }
    return text;
}

std::string markdown_text(const DataTable& table) {
    const auto line = [](const std::vector<std::string>& cells) {
        return fmt::format("| {} |\n", fmt::join(cells, " | "));
    };
    const std::vector<std::string> headings = page_columns(table).headings;
    std::string text = line(headings) + line(std::vector<std::string>(headings.size(), "---"));
    for (const DataTable::Row& row : table.rows()) {
        text += line(cells_of(row));
    }
    return text;
}

}  // namespace tiretherm::post
